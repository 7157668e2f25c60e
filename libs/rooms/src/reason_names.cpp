#include "roomgraph/rooms/reason_names.h"

namespace roomgraph {
namespace {

constexpr PassageReason kReasons[] = {PassageReason::wallOnBothSides, PassageReason::wallOnOneSide,
                                      PassageReason::narrowing, PassageReason::mouth,
                                      PassageReason::unseenSide};

}  // namespace

const char* reasonName(PassageReason reason) {
  switch (reason) {
    case PassageReason::wallOnBothSides:
      return "wall_on_both_sides";
    case PassageReason::wallOnOneSide:
      return "wall_on_one_side";
    case PassageReason::narrowing:
      return "narrowing";
    case PassageReason::mouth:
      return "mouth";
    case PassageReason::unseenSide:
      return "unseen_side";
  }
  return "";
}

std::optional<PassageReason> reasonOfName(const std::string& name) {
  for (const PassageReason reason : kReasons)
    if (name == reasonName(reason)) return reason;
  return std::nullopt;
}

}  // namespace roomgraph
