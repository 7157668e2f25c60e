#pragma once
#include <cstdint>

#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

// In:   a map drawn with the levels of FloorPlan.h
// Out:  the same map as a SLAM program would have left it

struct RoughenWallsOptions {
  int missingPerMille = 50;  ///< of the wall cells at free space that are lost
  int addedPerMille = 50;    ///< of the free cells at walls that are taken for wall
  std::uint32_t seed = 1;
};

/** Makes the faces of walls as ragged as those of real maps. Half of the lost cells become free,
 *  half unknown. Changes the map in place: large maps have no room for a second one. O(cells). */
void roughenWalls(GreyMap& map, const RoughenWallsOptions& options);

}  // namespace roomgraph
