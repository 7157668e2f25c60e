#include <algorithm>

#include "grid_of_points.h"
#include "read_layer_points.h"
#include "readers.h"
#include "roomgraph/base/remedies.h"
#include "roomgraph/scans/find_slice.h"
#include "roomgraph/scans/object_header.h"
#include "roomgraph/scans/read_points.h"

namespace roomgraph {
namespace {

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
  while (reader.left() > 0) {
    const void* end = std::memchr(reader.peek(), kObjectEnd, reader.left());
    if (!end) break;
    reader.skip(std::uint64_t(static_cast<const std::uint8_t*>(end) - reader.peek()) + 1);
    if (followsLayer({reader.peek(), reader.left()}, isLast, mapVersion)) return;
  }
  refuse(reader.file(), "it is cut short or damaged", kSaveMapAgain);
}

/** Lines and planes, which are no part of a grid. */
void skipFeatures(ByteReader& reader) {
  const std::string container = readText(reader), element = readText(reader);
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
    layer.name = readText(reader);
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
  map.notes.push_back(
      {"slice", "its points are cut: " + sliceText(slice) + " (see --slice)", std::nullopt});
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
    map.notes.push_back(
        {"layer",
         "its layer '" + layer.name + "' is read, of " + namesOf(layers) + " (see --layer)",
         std::nullopt});
  return map;
}

}  // namespace roomgraph
