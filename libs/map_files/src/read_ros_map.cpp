#include <algorithm>
#include <array>
#include <cmath>

#include "readers.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/images/read_image.h"
#include "roomgraph/map_files/ros_map_yaml.h"

namespace roomgraph {
namespace {

constexpr double kRounding = 1e-6;  // of what is computed from the numbers of a yaml

/** A rotation about the origin of a frame, and its way back. */
struct Turn {
  double cosine = 1, sine = 0;

  Point operator()(Point p) const { return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y}; }
  Point back(Point p) const { return {cosine * p.x + sine * p.y, cosine * p.y - sine * p.x}; }
};

/** Exact for quarter turns, of which the yaw of a yaml is a rounded number. */
Turn turnOf(double yaw, const GridFrame& frame) {
  const double quarters = std::round(yaw / M_PI_2);
  const double farthest = std::hypot(double(frame.width), double(frame.height));  // [cells]
  if (std::abs(yaw - quarters * M_PI_2) * farthest >= 0.25) return {std::cos(yaw), std::sin(yaw)};
  constexpr std::array<Turn, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return exact[std::size_t(int(quarters) % 4 + 4) % 4];
}

/** Around the turned map; where its corners meet cells, no cell is added for rounding. */
GridFrame frameOf(const GridFrame& from, const Turn& turn, const std::string& file) {
  const double w = from.width * from.resolution, h = from.height * from.resolution;
  Box box;
  for (const Point corner : {Point{}, Point{w, 0}, Point{0, h}, Point{w, h}})
    box.include(turn(corner));
  const double columns = std::ceil(box.size().x / from.resolution - kRounding);
  const double rows = std::ceil(box.size().y / from.resolution - kRounding);
  if (columns * rows > double(kMostCells))
    refuse(file, "turned by its yaw it has more than 400 million cells", "crop it");
  GridFrame frame = from;
  frame.width = int(columns), frame.height = int(rows);
  frame.origin = from.origin + box.low;
  return frame;
}

/** The map turned by `yaw` [rad, counter-clockwise] about the origin of its frame, in a frame that
 *  is along the axes again: cells keep their size, and those that the turned map does not cover are
 *  `outside`. Quarter turns move whole cells; what a turn misses of one by less than a quarter of a
 *  cell at the far corner counts as rounding. Any other turn gives each cell the nearest of the
 *  map, and none of the cells as dark as `darkest` is lost. Throws DataError, in the name of
 *  `file`, where the result has more than kMostCells. O(cells). */
GreyMap turned(const GreyMap& map, double yaw, std::uint8_t outside, std::uint8_t darkest,
               const std::string& file) {
  const Turn turn = turnOf(yaw, map.frame);
  GreyMap out = map;
  out.frame = frameOf(map.frame, turn, file);
  out.grey.assign(out.frame.cellCount(), outside);
  const Point pivot = map.frame.origin;
  for (Cell c{0, 0}; c.y < out.frame.height; ++c.y)
    for (c.x = 0; c.x < out.frame.width; ++c.x) {
      const Cell from = map.frame.cellAt(pivot + turn.back(out.frame.center(c) - pivot));
      if (map.frame.contains(from)) out.grey[out.frame.index(c)] = map.grey[map.frame.index(from)];
    }
  for (Cell c{0, 0}; c.y < map.frame.height; ++c.y)
    for (c.x = 0; c.x < map.frame.width; ++c.x) {
      const std::uint8_t grey = map.grey[map.frame.index(c)];
      const Cell to = out.frame.cellAt(pivot + turn(map.frame.center(c) - pivot));
      if (grey > darkest || !out.frame.contains(to)) continue;
      std::uint8_t& there = out.grey[out.frame.index(to)];
      there = std::min(there, grey);
    }
  return out;
}

bool isText(ByteView bytes) {
  return std::all_of(bytes.data, bytes.data + bytes.size, [](std::uint8_t c) {
    return c >= 0x20 || c == '\t' || c == '\n' || c == '\r';
  });
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
  const double free = std::floor(100 * map.freeBelow + kRounding);
  const double occupied = std::ceil(100 * map.occupiedAbove - kRounding);
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
  if (std::abs(ros.freeBelow - threshold) > kRounding || ros.negate || ros.mode != "trinary")
    return false;
  const auto count = countIf(grey, [](std::uint8_t level) { return level == unknown; });
  const auto darker =
      countIf(grey, [](std::uint8_t level) { return level >= darkestFree && level < unknown; });
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
                                   ros.occupiedAbove, ros.freeBelow)});
  if (isSavedByHumble(ros, map.grey)) {
    map.freeBelow = RosMapYaml().freeBelow;
    map.notes.push_back({"humble_thresholds",
                         "its free_thresh 0.25 would make its grey of unknown cells, 205, free, as "
                         "the map_saver of ROS 2 Humble writes it: read with free_thresh 0.196"});
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
  if (std::abs(ros.yaw) <= kRounding) return map;
  const double darkest = 255 * (1 - map.occupiedAbove);
  map = turned(map, ros.yaw, unknownGrey(map), std::uint8_t(std::clamp(darkest, 0.0, 255.0)), file);
  map.notes.push_back(
      {"turned",
       formatted("its origin has a yaw of %.6g degrees: the cells are turned into the map frame",
                 ros.yaw * 180 / M_PI)});
  return map;
}

}  // namespace

bool isRosMap(CheckedFile& file) {
  if (file.claimedSize() > 1 << 16 || !isText(file.head())) return false;
  const std::string text = file.head().text();
  return text.find("image:") != std::string::npos || text.find("image\":") != std::string::npos;
}

std::string pictureOfRosMap(CheckedFile& file) {
  return pictureOf(readRosMapYaml(file.content().text(), file.name()), file.name());
}

GreyMap readRosMap(CheckedFile& file, const LoadGridOptions&) {
  const ByteView yaml = file.content();
  const RosMapYaml ros = readRosMapYaml(yaml.text(), file.name());
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
