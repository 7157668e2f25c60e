#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

/** What a robot saw from one place. */
struct Keyframe {
  Transform2D pose;  ///< map <- robot
  std::vector<Point>
      ends;  ///< where beams met something, in the order of the scan [m, robot frame]
};

/** The horizontal 2D range scans of a simplemap, in the order of the file; empty for every other
 *  kind of map. Beams without return or longer than `maxRange` [m] are left out. Checks as loadGrid
 *  does. O(file).
 *  @throws DataError where the file is missing or damaged. */
std::vector<Keyframe> loadKeyframes(const std::string& file, double maxRange);

}  // namespace roomgraph
