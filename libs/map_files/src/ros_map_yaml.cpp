#include "roomgraph/map_files/ros_map_yaml.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/grid/GridFrame.h"

namespace roomgraph {
namespace {

/** The number under `key`; throws DataError unless it lies in the range. */
double readNumber(const YAML::Node& node, const std::string& key, double low, double high,
                  const std::string& file) {
  double value = NAN;
  if (node && node.IsScalar() && YAML::convert<double>::decode(node, value) && value >= low &&
      value <= high)
    return value;
  refuse(file, node ? "its '" + key + "' is not a sensible number" : "it has no '" + key + "'",
         "correct the yaml");
}

void readOrigin(const YAML::Node& node, RosMapYaml& map, const std::string& file) {
  if (!node || !node.IsSequence() || node.size() < 2 || node.size() > 3)
    refuse(file, "it has no 'origin' of the form [x, y, yaw]", "correct the yaml");
  map.origin = {readNumber(node[0], "origin", -kFarthestOrigin, kFarthestOrigin, file),
                readNumber(node[1], "origin", -kFarthestOrigin, kFarthestOrigin, file)};
  if (node.size() == 3) map.yaw = readNumber(node[2], "origin", -10, 10, file);
}

bool readNegate(const YAML::Node& node, const std::string& file) {
  bool isNegated = false;
  if (!node || YAML::convert<bool>::decode(node, isNegated)) return isNegated;
  return readNumber(node, "negate", 0, 1, file) != 0;
}

void readOptional(const YAML::Node& yaml, const std::string& key, double& value,
                  const std::string& file) {
  if (yaml[key]) value = readNumber(yaml[key], key, 0, 1, file);
}

RosMapYaml parse(const YAML::Node& yaml, const std::string& file) {
  RosMapYaml map;
  map.image = yaml["image"].Scalar();
  if (map.image.empty()) refuse(file, "its 'image' names no file", "correct the yaml");
  map.resolution = readNumber(yaml["resolution"], "resolution", kSmallestCell, kLargestCell, file);
  readOrigin(yaml["origin"], map, file);
  map.negate = readNegate(yaml["negate"], file);
  readOptional(yaml, "occupied_thresh", map.occupiedAbove, file);
  readOptional(yaml, "free_thresh", map.freeBelow, file);
  map.hasThresholds = yaml["occupied_thresh"] && yaml["free_thresh"];
  if (map.freeBelow > map.occupiedAbove)
    refuse(file, "its 'free_thresh' is above its 'occupied_thresh'", "correct the yaml");
  map.mode = yaml["mode"] ? yaml["mode"].Scalar() : "trinary";
  if (map.mode != "trinary" && map.mode != "scale" && map.mode != "raw")
    refuse(file, "its 'mode' is none of trinary, scale, raw", "correct the yaml");
  return map;
}

/** What `use` makes of the yaml. @throws DataError where it is not that of a ROS map. */
template <class Use>
auto withYaml(const std::string& text, const std::string& file, const Use& use) {
  try {
    YAML::Node yaml = YAML::Load(text);
    if (!yaml.IsMap() || !yaml["image"])
      refuse(file, "it has no 'image', which a ROS map names", "correct the yaml");
    return use(yaml);
  } catch (const YAML::Exception& error) {
    refuse(file, "it is not valid yaml from line " + std::to_string(error.mark.line + 1) + " on",
           "correct the yaml");
  }
}

}  // namespace

RosMapYaml readRosMapYaml(const std::string& text, const std::string& file) {
  return withYaml(text, file, [&](const YAML::Node& yaml) { return parse(yaml, file); });
}

std::string pictureOf(const RosMapYaml& map, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path path = fs::path(file).parent_path() / map.image;
  std::error_code error;
  if (!fs::exists(path, error))
    refuse(file, "names the picture " + path.string() + ", which does not exist",
           "put it there, or correct 'image'");
  return path.string();
}

std::string rosMapYamlWith(const std::string& text,
                           const std::vector<std::pair<std::string, std::string>>& values,
                           const std::string& file) {
  return withYaml(text, file, [&](YAML::Node& yaml) {
    for (const auto& [key, value] : values) {
      yaml[key] = YAML::Load(value);
      // A line for each of several things.
      if (yaml[key].IsSequence() && yaml[key].size() > 0 && yaml[key][0].IsMap())
        yaml[key].SetStyle(YAML::EmitterStyle::Block);
    }
    return YAML::Dump(yaml) + "\n";
  });
}

}  // namespace roomgraph
