#pragma once
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** What the yaml of a ROS map says of its picture. */
struct RosMapYaml {
  std::string image, mode;  ///< "trinary", "scale" or "raw"
  double resolution = 0;    ///< [m]
  Point origin;             ///< of the lower left corner [m]
  double yaw = 0;           ///< of the picture about that corner [rad]
  bool negate = false;
  double occupiedAbove = 0.65, freeBelow = 0.196;  ///< those of map_server's own examples
  bool hasThresholds = false;                      ///< both stand in the yaml
};

// nav2_map_server
// In:   the text of a yaml
// Out:  RosMapYaml
// Next: readImage

/** @throws DataError in the name of `file` where a value is missing or absurd. */
RosMapYaml readRosMapYaml(const std::string& text, const std::string& file);

/** Where its picture lies. @throws DataError where it does not. */
std::string pictureOf(const RosMapYaml& map, const std::string& file);

/** The same yaml with other values, each a key and a value as yaml has it on one line; all other
 *  keys stay, comments go. @throws DataError like readRosMapYaml. */
std::string rosMapYamlWith(const std::string& text,
                           const std::vector<std::pair<std::string, std::string>>& values,
                           const std::string& file);

}  // namespace roomgraph
