#pragma once
#include <array>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

[[nodiscard]] constexpr std::array<const char*, 5> enumNames(PassageReason) {
  return {"wall_on_both_sides", "wall_on_one_side", "narrowing", "mouth", "unseen_side"};
}

}  // namespace roomgraph
