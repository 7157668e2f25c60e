#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "readers.h"
#include "roomgraph/base/byte_reader.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/find_slice.h"
#include "roomgraph/scans/mrpt_object.h"
#include "roomgraph/scans/object_header.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

using mrpt::math::TPoint3Df;

constexpr char kKeyframes[] = "KeyframePointCloudMap", kIncremental[] = "IncrementalPointCloud";
constexpr std::uint64_t kBeforePose = 8 + 8;  // number and time of a key frame

/** Steps to the next pose that is announced within so many bytes. Returns how far that was. */
std::optional<std::uint64_t> seekPose(ByteReader& reader, std::uint64_t most) {
  constexpr std::size_t header = 32;
  for (std::uint64_t step = 0; step <= most && reader.left() > 0; ++step, reader.skip(1)) {
    const auto object = peekObjectHeader({reader.peek(), std::min(reader.left(), header)});
    if (object && !object->isOldFormat && object->className == "CPose3D") return step;
  }
  return std::nullopt;
}

/** The number of key frames, which stands behind options whose layout is not known here. Without
 *  any, what is taken for the first may be a pose behind the layer. */
std::uint32_t readKeyframeCount(ByteReader& reader) {
  ByteReader ahead = reader;
  const auto distance = seekPose(ahead, 4096);
  if (!distance || *distance < kBeforePose + 4) return 0;
  reader.skip(*distance - kBeforePose - 4);
  const auto count = reader.get<std::uint32_t>();
  return count > reader.left() / 100 ? 0 : count;
}

void addPoints(ByteReader& reader, const mrpt::poses::CPose3D& pose, CloudPoints& points) {
  if (!isPointsMapClass(readObjectHeader(reader).className))
    refuse(reader.file(), "it is damaged: a key frame in it has no points", kSaveMapAgain);
  for (const TPoint3Df& local : readPoints(reader)) {
    const auto p = pose.composePoint(mrpt::math::TPoint3D(local));
    points.emplace_back(float(p.x), float(p.y), float(p.z));
  }
}

/** Reads the body of a layer of MOLA's KeyframePointCloudMap: the clouds of all key frames. Each
 *  may be followed by what is not known here. */
CloudPoints readKeyframeLayer(ByteReader& reader) {
  CloudPoints points;
  for (std::uint32_t n = readKeyframeCount(reader); n > 0; --n) {
    if (!seekPose(reader, reader.left()))
      refuse(reader.file(), "it is cut short or damaged", kSaveMapAgain);
    const auto pose = readPose3D(reader);
    if (reader.getFlag()) addPoints(reader, pose, points);
  }
  return points;
}

/** Whether the points of a metric map's layer of this class can be read: MRPT's point maps, and
 *  MOLA's IncrementalPointCloud and KeyframePointCloudMap. */
bool hasLayerPoints(const std::string& className) {
  return isPointsMapClass(className) || className == kKeyframes || className == kIncremental;
}

/** Reads the points of the layer whose object begins here, in the frame of the map. What follows
 *  its last point is left. */
CloudPoints readLayerPoints(ByteReader& reader) {
  const std::string className = readObjectHeader(reader).className;
  if (className == kKeyframes) return readKeyframeLayer(reader);
  if (className == kIncremental)
    readObjectHeader(reader);  // it is kept as one of MRPT's point maps
  return readPoints(reader);
}

constexpr double kMargin = 0.5;  // around all points [m]
constexpr std::uint8_t kWallGrey = 0, kFreeGrey = 255;

GridFrame frameOf(const std::vector<TPoint3Df>& points, double resolution,
                  const std::string& file) {
  Box box;
  for (const TPoint3Df& p : points) box.include({double(p.x), double(p.y)});
  const auto first = [&](double value) { return std::floor((value - kMargin) / resolution); };
  const auto last = [&](double value) { return std::ceil((value + kMargin) / resolution); };
  const double width = last(box.high.x) - first(box.low.x),
               height = last(box.high.y) - first(box.low.y);
  if (!(width * height <= double(kMostCells)))
    refuse(file, "its points reach over more than 400 million cells", "use a coarser resolution");
  GridFrame frame;
  frame.width = int(width), frame.height = int(height), frame.resolution = resolution;
  frame.origin = {first(box.low.x) * resolution, first(box.low.y) * resolution};
  return frame;
}

/** Fills gaps of up to `most` cells between free ones, along rows (step 1) or columns. */
void fillGaps(std::vector<std::uint8_t>& grey, const GridFrame& frame, int most, bool isAlongRows) {
  const int lines = isAlongRows ? frame.height : frame.width;
  const int length = isAlongRows ? frame.width : frame.height;
  for (int line = 0; line < lines; ++line) {
    const auto at = [&](int i) -> std::uint8_t& {
      return grey[frame.index(isAlongRows ? Cell{i, line} : Cell{line, i})];
    };
    int previous = -1;
    for (int i = 0; i < length; ++i) {
      if (at(i) == kWallGrey) previous = -1;
      if (at(i) != kFreeGrey) continue;
      if (previous >= 0 && i - previous - 1 <= most)
        for (int k = previous + 1; k < i; ++k) at(k) = kFreeGrey;
      previous = i;
    }
  }
}

/** A grid of points alone, which nobody tells from where they were seen: cells with points in the
 *  slice are occupied, others where the floor is seen are free, and so are gaps in the floor of up
 *  to 0.3 m. Throws DataError, in the name of `file`, for more than kMostCells. O(points +
 *  cells). */
GreyMap gridOfPoints(const std::vector<TPoint3Df>& points, const Slice& slice, double resolution,
                     const std::string& file) {
  GreyMap map;
  map.frame = frameOf(points, resolution, file);
  map.grey.assign(map.frame.cellCount(), 128);  // nobody has seen them
  const auto cellOf = [&](const TPoint3Df& p) -> std::uint8_t& {
    return map.grey[map.frame.index(map.frame.cellAt({double(p.x), double(p.y)}))];
  };
  for (const TPoint3Df& p : points)
    if (std::abs(double(p.z) - slice.floor) <= 0.15) cellOf(p) = kFreeGrey;
  for (const TPoint3Df& p : points)
    if (slice.contains(double(p.z))) cellOf(p) = kWallGrey;
  const int gap = int(0.3 / resolution);
  fillGaps(map.grey, map.frame, gap, true);
  fillGaps(map.grey, map.frame, gap, false);
  map.occupiedAbove = 0.55;
  map.freeBelow = 0.45;
  return map;
}

// As stored, with its namespace; the shortest known is "mola::NDT".
constexpr int kShortestStoredClass = 8;

/** A layer of the map, of which only one is read. */
struct Layer {
  std::string name, className;
  std::uint64_t at = 0;  ///< where its object begins
  bool isEmpty = false;  ///< holds points, but none that can be used
};

bool isGrid(const Layer& layer) { return layer.className == "COccupancyGridMap2D"; }
bool isPoints(const Layer& layer) { return hasLayerPoints(layer.className); }

/** What separates a name from bytes of another layer that look like one. */
bool isPrintable(ByteView bytes) {
  return std::all_of(bytes.data, bytes.data + bytes.size,
                     [](std::uint8_t c) { return c >= 0x20 && c != 0x7f; });
}

/** Whether a name and an object begin at `bytes`, or what stands behind the last layer. */
bool followsLayer(ByteView bytes, bool isLast, int mapVersion) {
  if (isLast && mapVersion == 0) return bytes.size == 1 && bytes.data[0] == kObjectEnd;
  if (isLast) return startsWithOptional(bytes);
  constexpr std::uint32_t longest = 200;
  std::uint32_t length;
  if (bytes.size < sizeof length) return false;
  std::memcpy(&length, bytes.data, sizeof length);
  if (length > longest || bytes.size < sizeof length + length) return false;
  if (!isPrintable({bytes.data + sizeof length, length})) return false;
  const ByteView object{bytes.data + sizeof length + length, bytes.size - sizeof length - length};
  const auto next = peekObjectHeader(object);
  return next && !next->isOldFormat && (object.data[0] & 0x7f) >= kShortestStoredClass;
}

/** Steps over what is left of a layer. */
void skipLayer(ByteReader& reader, bool isLast, int mapVersion) {
  skipObject(reader, [&](ByteView next) { return followsLayer(next, isLast, mapVersion); });
}

/** Lines and planes, which are no part of a grid. */
void skipFeatures(ByteReader& reader) {
  const std::string container = reader.getText(), element = reader.getText();
  if (container != "std::vector" || element.find("TLine3D") == std::string::npos)
    refuse(reader.file(), "it is damaged: its lines are missing", kSaveMapAgain);
  constexpr std::uint64_t line = 6 * sizeof(double), plane = 7 * sizeof(double);
  for (const std::uint64_t size : {line, plane, line})
    reader.skip(std::uint64_t(reader.get<std::uint32_t>()) * size);
}

std::vector<Layer> readLayers(ByteReader& reader) {
  const ObjectHeader map = readObjectHeader(reader);
  checkVersion(reader, map, 5);
  skipFeatures(reader);
  const auto count = reader.get<std::uint32_t>();
  if (count > 1000)
    refuse(reader.file(), "it is damaged: it claims " + std::to_string(count) + " layers",
           kSaveMapAgain);
  std::vector<Layer> layers;
  for (std::uint32_t i = 0; i < count; ++i) {
    Layer layer;
    layer.name = reader.getText();
    layer.at = reader.position();
    ByteReader object = reader;
    layer.className = readObjectHeader(reader).className;
    if (isGrid(layer))
      reader = object, readGridmapObject(reader);
    else {
      if (isPointsMapClass(layer.className)) layer.isEmpty = readPoints(reader).empty();
      skipLayer(reader, i + 1 == count, map.version);
    }
    layers.push_back(layer);
  }
  return layers;
}

std::string namesOf(const std::vector<Layer>& layers) {
  std::string names;
  for (const Layer& layer : layers)
    names += (names.empty() ? "" : ", ") + layer.name + " (" + layer.className + ")";
  return names.empty() ? "none" : names;
}

/** The one that is asked for, else the first grid, else the first points. */
Layer chosen(const std::vector<Layer>& layers, const std::string& name, const std::string& file) {
  const auto first = [&](auto test) { return std::find_if(layers.begin(), layers.end(), test); };
  auto found = first([&](const Layer& layer) { return layer.name == name; });
  if (name.empty()) found = first(isGrid);
  if (name.empty() && found == layers.end())
    found = first([](const Layer& layer) { return isPoints(layer) && !layer.isEmpty; });
  if (name.empty() && found == layers.end()) found = first(isPoints);
  if (found == layers.end())
    refuse(file,
           name.empty() ? "has no layer with a grid or points: " + namesOf(layers)
                        : "has no layer '" + name + "': " + namesOf(layers),
           "give it a layer with a grid, or name one with --layer");
  return *found;
}

GreyMap slicedLayer(ByteReader& reader, const Layer& layer, const LoadGridOptions& options) {
  const auto points = readLayerPoints(reader);
  Voxels voxels;
  for (const auto& p : points) voxels.add(double(p.x), double(p.y), double(p.z));
  if (voxels.empty())
    refuse(reader.file(), "its layer '" + layer.name + "' has no points", kSaveMapAgain);
  const Slice slice = findSlice(voxels, options);
  if (slice.isFlat || !slice.isFloorSeen)
    refuse(reader.file(),
           "its layer '" + layer.name + "' has points of " +
               (slice.isFlat ? "one height only" : "walls only") +
               ": without a floor nothing tells what is free",
           "give it a layer with a grid");
  refuseEmptySlice(slice, reader.file());
  GreyMap map = gridOfPoints(points, slice, options.resolution, reader.file());
  map.notes.push_back({"slice", "its points are cut: " + sliceText(slice) + " (see --slice)"});
  return map;
}

}  // namespace

bool isMetricMap(CheckedFile& file) {
  const auto object = peekObjectHeader(file.head());
  return object && object->className == "metric_map_t";
}

GreyMap readMetricMap(CheckedFile& file, const LoadGridOptions& options) {
  ByteReader reader(file.content(), file.name());
  const std::vector<Layer> layers = readLayers(reader);
  const Layer layer = chosen(layers, options.layer, file.name());
  if (!isGrid(layer) && !isPoints(layer))
    refuse(file.name(), "its layer '" + layer.name + "' is a " + layer.className,
           "name a layer with a grid or points with --layer");
  ByteReader object(file.content(), file.name());
  object.skip(layer.at);
  GreyMap map = isGrid(layer) ? readGridmapObject(object) : slicedLayer(object, layer, options);
  if (layers.size() > 1)
    map.notes.push_back({"layer", "its layer '" + layer.name + "' is read, of " + namesOf(layers) +
                                      " (see --layer)"});
  return map;
}

}  // namespace roomgraph
