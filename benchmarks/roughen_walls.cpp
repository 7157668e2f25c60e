#include "roughen_walls.h"

#include "FloorPlan.h"
#include "Random.h"

namespace roomgraph {
namespace {

bool wasWall(std::uint8_t level) {
  return level == grey::kWall || level == grey::kMissingWall || level == grey::kUncertainWall;
}

bool wasFree(std::uint8_t level) { return level == grey::kFree || level == grey::kAddedWall; }

/** Whether one of the four neighbours had the property before any noise. */
template <class Property>
bool hasNeighbour(const GreyMap& map, Cell c, Property had) {
  const auto is = [&](Cell near) {
    return map.frame.contains(near) && had(map.grey[map.frame.index(near)]);
  };
  return is({c.x - 1, c.y}) || is({c.x + 1, c.y}) || is({c.x, c.y - 1}) || is({c.x, c.y + 1});
}

}  // namespace

void roughenWalls(GreyMap& map, const RoughenWallsOptions& options) {
  Random random(options.seed);
  for (int y = 0; y < map.frame.height; ++y)
    for (int x = 0; x < map.frame.width; ++x) {
      std::uint8_t& level = map.grey[map.frame.index({x, y})];
      if (level == grey::kWall && hasNeighbour(map, {x, y}, wasFree)) {
        if (random.below(1000) < options.missingPerMille)
          level = random.oneIn(2) ? grey::kMissingWall : grey::kUncertainWall;
      } else if (level == grey::kFree && hasNeighbour(map, {x, y}, wasWall)) {
        if (random.below(1000) < options.addedPerMille) level = grey::kAddedWall;
      }
    }
}

}  // namespace roomgraph
