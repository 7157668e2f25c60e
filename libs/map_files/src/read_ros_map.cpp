#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "readers.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/images/read_image.h"
#include "stored_cells.h"
#include "turn_map.h"

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr double kFarthestOrigin = 1e7;

struct RosMap {
  std::string image, mode;
  double resolution = 0;
  Point origin;
  double yaw = 0;
  bool negate = false;
  double occupiedAbove = 0.65, freeBelow = 0.196;  ///< those of map_server's own examples
  bool hasThresholds = false;                      ///< both stand in the yaml
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
  refuse(file, node ? "its '" + key + "' is not a sensible number" : "it has no '" + key + "'",
         "correct the yaml");
}

void readOrigin(const YAML::Node& node, RosMap& map, const std::string& file) {
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

RosMap parse(const YAML::Node& yaml, const std::string& file) {
  RosMap map;
  map.image = yaml["image"].Scalar();
  if (map.image.empty()) refuse(file, "its 'image' names no file", "correct the yaml");
  map.resolution = readNumber(yaml["resolution"], "resolution", 1e-4, 1e3, file);
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

std::string textOf(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data), bytes.size};
}

RosMap parse(ByteView bytes, const std::string& file) {
  try {
    const YAML::Node yaml = YAML::Load(textOf(bytes));
    if (!yaml.IsMap() || !yaml["image"])
      refuse(file, "it has no 'image', which a ROS map names", "correct the yaml");
    return parse(yaml, file);
  } catch (const YAML::Exception& error) {
    refuse(file, "it is not valid yaml from line " + std::to_string(error.mark.line + 1) + " on",
           "correct the yaml");
  }
}

double occupancyOf(std::uint8_t grey) { return 1 - grey / 255.0; }

/** A grey that the thresholds call neither occupied nor free. */
std::uint8_t unknownGrey(const GreyMap& map) {
  constexpr std::uint8_t middle = 128;
  const double p = occupancyOf(middle);
  if (p > map.freeBelow && p < map.occupiedAbove) return middle;
  return std::uint8_t(std::lround(255 * (1 - (map.freeBelow + map.occupiedAbove) / 2)));
}

/** The thresholds, which are meant for percents, for the greys that stand for them; beyond 100
 *  pixels say nothing. */
void applyRaw(GreyMap& map) {
  constexpr double rounding = 1e-6;
  const double free = std::floor(100 * map.freeBelow + rounding);
  const double occupied = std::ceil(100 * map.occupiedAbove - rounding);
  map.freeBelow = occupancyOf(greyOfPercent(int(free)));
  map.occupiedAbove = occupancyOf(greyOfPercent(int(occupied)));
  const std::uint8_t unknown = unknownGrey(map);
  for (auto& level : map.grey) level = level > 100 ? unknown : greyOfPercent(level);
}

/** The map_saver of ROS 2 Humble and Iron writes 205 for unknown cells and a free_thresh that takes
 *  them for free ones. A map drawn in greys for which that threshold may be meant also has some a
 *  little darker than 205. */
bool isSavedByHumble(const RosMap& ros, const std::vector<std::uint8_t>& grey) {
  constexpr double threshold = 0.25;
  constexpr std::uint8_t unknown = 205, darkestFree = 192;
  if (std::abs(ros.freeBelow - threshold) > 1e-6 || ros.negate || ros.mode != "trinary")
    return false;
  const auto count = std::count(grey.begin(), grey.end(), unknown);
  const auto darker = std::count_if(grey.begin(), grey.end(), [](std::uint8_t level) {
    return level >= darkestFree && level < unknown;
  });
  return count > 0 && darker <= count / 100;
}

/** The map_server's rules, but that the unknown of Humble's maps stays unknown. */
void applyMode(const RosMap& ros, GreyMap& map) {
  map.occupiedAbove = ros.occupiedAbove;
  map.freeBelow = ros.freeBelow;
  if (!ros.hasThresholds)
    map.notes.push_back({"default_thresholds",
                         formatted("it does not name both occupied_thresh and free_thresh: read "
                                   "with %g and %g",
                                   ros.occupiedAbove, ros.freeBelow),
                         std::nullopt});
  if (isSavedByHumble(ros, map.grey)) {
    map.freeBelow = RosMap().freeBelow;
    map.notes.push_back({"humble_thresholds",
                         "its free_thresh 0.25 would make its grey of unknown cells, 205, free, as "
                         "the map_saver of ROS 2 Humble writes it: read with free_thresh 0.196",
                         std::nullopt});
  }
  if (ros.mode == "raw")
    applyRaw(map);
  else if (ros.negate)
    for (auto& level : map.grey) level = std::uint8_t(255 - level);
}

/** Pixels that are not opaque are unknown, whatever their colour. */
void applyTransparency(const std::vector<std::uint8_t>& isClear, GreyMap& map) {
  const std::uint8_t unknown = unknownGrey(map);
  for (std::size_t i = 0; i < isClear.size(); ++i)
    if (isClear[i]) map.grey[i] = unknown;
}

GreyMap inMapFrame(const RosMap& ros, GreyMap map, const std::string& file) {
  if (std::abs(ros.yaw) <= 1e-6) return map;
  const double darkest = 255 * (1 - map.occupiedAbove);
  map = turned(map, ros.yaw, unknownGrey(map), std::uint8_t(std::clamp(darkest, 0.0, 255.0)), file);
  map.notes.push_back(
      {"turned",
       formatted("its origin has a yaw of %.6g degrees: the cells are turned into the map frame",
                 ros.yaw * 180 / M_PI),
       std::nullopt});
  return map;
}

/** Where its picture lies. */
std::string pictureOf(const RosMap& ros, const std::string& name) {
  const fs::path path = fs::path(name).parent_path() / ros.image;
  std::error_code error;
  if (!fs::exists(path, error))
    refuse(name, "names the picture " + path.string() + ", which does not exist",
           "put it there, or correct 'image'");
  return path.string();
}

}  // namespace

bool isRosMap(CheckedFile& file) {
  if (file.claimedSize() > 1 << 16 || !isText(file.head())) return false;
  const std::string text = textOf(file.head());
  return text.find("image:") != std::string::npos || text.find("image\":") != std::string::npos;
}

std::string pictureOfRosMap(CheckedFile& file) {
  return pictureOf(parse(file.content(), file.name()), file.name());
}

GreyMap readRosMap(CheckedFile& file, const LoadGridOptions&) {
  const ByteView yaml = file.content();
  const RosMap ros = parse(yaml, file.name());
  CheckedFile picture(pictureOf(ros, file.name()));
  GreyMap map;
  readImage(picture, map);
  map.frame.resolution = ros.resolution;
  map.frame.origin = ros.origin;
  applyMode(ros, map);
  applyTransparency(readClearPixels(picture), map);
  map = inMapFrame(ros, std::move(map), file.name());
  map.source.sha256 = sha256Of(yaml, picture.content());
  return map;
}

}  // namespace roomgraph
