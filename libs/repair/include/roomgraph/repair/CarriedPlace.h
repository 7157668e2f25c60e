#pragma once
#include <array>
#include <optional>
#include <string>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** A place that somebody has marked on a map: a goal, a dock, a corner of a zone. */
struct Place {
  std::string name;
  Transform2D pose;  ///< map <- place
  /** Of an area, or a part of it: these lie at walls, so in one it is neither gone nor unsure. */
  bool isCorner = false;
};

enum class CarryState {
  carried,  ///< it is there, as far as the maps tell
  unsure,   ///< it is likely there: look at it before it is used
  gone,     ///< what was free there is a wall now
  unseen    ///< the new map has not been there
};

[[nodiscard]] constexpr std::array<const char*, 4> enumNames(CarryState) {
  return {"carried", "unsure", "gone", "unseen"};
}

/** A place on another map. */
struct CarriedPlace {
  /** new map <- place: the best that is known, also where that is not sure; none where neither map
   *  tells anything. */
  std::optional<Transform2D> pose;
  CarryState state = CarryState::unseen;
  double error = 0;    ///< how far it may be off, as a standard deviation [m]
  std::string reason;  ///< of any state but carried, one line
};

}  // namespace roomgraph
