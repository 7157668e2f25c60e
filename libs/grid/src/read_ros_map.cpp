#include "read_ros_map.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "read_image.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLongestYaml = 1 << 16;
constexpr double kFarthest = 1e7;

struct RosMap {
  std::string image, mode;
  double resolution = 0;
  Point origin;
  bool negate = false;
  double occupiedAbove = 0.65, freeBelow = 0.196;  ///< those of map_server's own examples
};

bool isText(ByteView bytes) {
  return std::all_of(bytes.data, bytes.data + bytes.size, [](std::uint8_t c) {
    return c >= 0x20 || c == '\t' || c == '\n' || c == '\r';
  });
}

/** The number under `key`; throws DataError unless it lies in the range. */
double readNumber(const YAML::Node& node, const std::string& key, double low, double high,
                  const std::string& file) {
  double value = NAN;
  if (node && node.IsScalar() && YAML::convert<double>::decode(node, value) && value >= low &&
      value <= high)
    return value;
  refuse(file, node ? "its '" + key + "' is no sensible number" : "it has no '" + key + "'",
         "correct the yaml");
}

Point readOrigin(const YAML::Node& node, const std::string& file) {
  if (!node || !node.IsSequence() || node.size() < 2 || node.size() > 3)
    refuse(file, "it has no 'origin' of the form [x, y, yaw]", "correct the yaml");
  const double yaw = node.size() == 3 ? readNumber(node[2], "origin", -10, 10, file) : 0;
  if (std::abs(yaw) > 1e-6)
    refuse(file, "its origin has a yaw other than 0, which is not supported",
           "turn the picture and set the yaw to 0");
  return {readNumber(node[0], "origin", -kFarthest, kFarthest, file),
          readNumber(node[1], "origin", -kFarthest, kFarthest, file)};
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

RosMap parse(const YAML::Node& yaml, const std::string& file) {
  RosMap map;
  map.image = yaml["image"].Scalar();
  if (map.image.empty()) refuse(file, "its 'image' names no file", "correct the yaml");
  map.resolution = readNumber(yaml["resolution"], "resolution", 1e-4, 1e3, file);
  map.origin = readOrigin(yaml["origin"], file);
  map.negate = readNegate(yaml["negate"], file);
  readOptional(yaml, "occupied_thresh", map.occupiedAbove, file);
  readOptional(yaml, "free_thresh", map.freeBelow, file);
  if (map.freeBelow > map.occupiedAbove)
    refuse(file, "its 'free_thresh' is above its 'occupied_thresh'", "correct the yaml");
  map.mode = yaml["mode"] ? yaml["mode"].Scalar() : "trinary";
  if (map.mode != "trinary" && map.mode != "scale" && map.mode != "raw")
    refuse(file, "its 'mode' is none of trinary, scale, raw", "correct the yaml");
  return map;
}

std::optional<RosMap> parse(ByteView bytes, const std::string& file) {
  const std::string text(reinterpret_cast<const char*>(bytes.data), bytes.size);
  try {
    const YAML::Node yaml = YAML::Load(text);
    if (!yaml.IsMap() || !yaml["image"]) return std::nullopt;
    return parse(yaml, file);
  } catch (const YAML::Exception& error) {
    if (text.find("image:") == std::string::npos) return std::nullopt;
    refuse(file, "it is no valid yaml from line " + std::to_string(error.mark.line + 1) + " on",
           "correct the yaml");
  }
}

/** Raw pixels are percents of being occupied; beyond 100 they say nothing. */
std::uint8_t greyOfRaw(int pixel) {
  return std::uint8_t(pixel > 100 ? 128 : (255 * (100 - pixel) + 50) / 100);
}

void applyMode(const RosMap& ros, std::vector<std::uint8_t>& grey) {
  if (ros.mode == "raw")
    for (auto& level : grey) level = greyOfRaw(level);
  else if (ros.negate)
    for (auto& level : grey) level = std::uint8_t(255 - level);
}

}  // namespace

std::optional<GreyMap> readRosMap(CheckedFile& file) {
  if (file.claimedSize() > kLongestYaml || !isText(file.head())) return std::nullopt;
  const ByteView yaml = file.content();
  const auto ros = parse(yaml, file.name());
  if (!ros) return std::nullopt;

  const fs::path path = fs::path(file.name()).parent_path() / ros->image;
  std::error_code error;
  if (!fs::exists(path, error))
    refuse(file.name(), "names the picture " + path.string() + ", which does not exist",
           "put it there, or correct 'image'");
  CheckedFile picture(path.string());
  GreyMap map;
  readImage(picture, map);
  applyMode(*ros, map.grey);
  map.frame.resolution = ros->resolution;
  map.frame.origin = ros->origin;
  map.occupiedAbove = ros->occupiedAbove;
  map.freeBelow = ros->freeBelow;
  map.source.kind = "ros_map";
  map.source.sha256 = sha256Of(yaml, picture.content());
  return map;
}

}  // namespace roomgraph
