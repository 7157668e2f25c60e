#include <algorithm>
#include <cmath>

#include "readers.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/images/read_image.h"
#include "roomgraph/map_files/ros_map_yaml.h"
#include "stored_cells.h"
#include "turn_map.h"

namespace roomgraph {
namespace {

bool isText(ByteView bytes) {
  return std::all_of(bytes.data, bytes.data + bytes.size, [](std::uint8_t c) {
    return c >= 0x20 || c == '\t' || c == '\n' || c == '\r';
  });
}

std::string textOf(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data), bytes.size};
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
bool isSavedByHumble(const RosMapYaml& ros, const std::vector<std::uint8_t>& grey) {
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
void applyMode(const RosMapYaml& ros, GreyMap& map) {
  map.occupiedAbove = ros.occupiedAbove;
  map.freeBelow = ros.freeBelow;
  if (!ros.hasThresholds)
    map.notes.push_back({"default_thresholds",
                         formatted("it does not name both occupied_thresh and free_thresh: read "
                                   "with %g and %g",
                                   ros.occupiedAbove, ros.freeBelow),
                         std::nullopt});
  if (isSavedByHumble(ros, map.grey)) {
    map.freeBelow = RosMapYaml().freeBelow;
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

GreyMap inMapFrame(const RosMapYaml& ros, GreyMap map, const std::string& file) {
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

}  // namespace

bool isRosMap(CheckedFile& file) {
  if (file.claimedSize() > 1 << 16 || !isText(file.head())) return false;
  const std::string text = textOf(file.head());
  return text.find("image:") != std::string::npos || text.find("image\":") != std::string::npos;
}

std::string pictureOfRosMap(CheckedFile& file) {
  return pictureOf(readRosMapYaml(textOf(file.content()), file.name()), file.name());
}

GreyMap readRosMap(CheckedFile& file, const LoadGridOptions&) {
  const ByteView yaml = file.content();
  const RosMapYaml ros = readRosMapYaml(textOf(yaml), file.name());
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
