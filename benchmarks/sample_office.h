#pragma once
#include <vector>

#include "roomgraph/geometry/Point.h"
#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

/** The office behind the samples of share/roomgraph/maps, and a robot's way through it. */
struct SampleOffice {
  GreyMap map;              ///< complete and clean; the robot starts at (0, 0)
  std::vector<Point> tour;  ///< corners of the way [m, map frame]
};

/** 30 m x 20 m: a corridor all round a core, rooms of different sizes on both sides of it, a hall
 *  with two pillars, an L-shaped room, a dead-end corridor, rooms that the tour leaves out. */
SampleOffice sampleOffice();

}  // namespace roomgraph
