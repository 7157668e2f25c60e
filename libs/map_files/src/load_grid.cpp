#include "roomgraph/map_files/load_grid.h"

#include <new>
#include <optional>
#include <sstream>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/map_files/grid_of_scans.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/scans/make_keyframes.h"
#include "roomgraph/scans/object_header.h"

namespace roomgraph {
namespace {

/** MRPT's own classes, as against a word that begins a text. */
bool isRegisteredName(const std::string& className) {
  return className.size() > 1 && className[0] == 'C' && className[1] >= 'A' && className[1] <= 'Z';
}

/** What is no map, and the programs that open it. */
struct OtherFile {
  const char* sign;
  const char* problem;
  const char* remedy;
};
/** By the class of an MRPT object. */
constexpr OtherFile kOtherObjects[] = {
    {"CMapComparison", "is a comparison, and no map",
     "open it with 'roomgraph info' or RawLogViewer"},
    {"CRoomGraph", "is a graph, and no map", "open it with 'roomgraph info' or RawLogViewer"},
    {"COpenGLScene", "is a scene, and no map", "open it with SceneViewer3D"},
    {"Scene", "is a scene, and no map", "open it with SceneViewer3D"},
    {"CActionCollection", "is a log, and no map", "open it with RawLogViewer, or make a map of it"},
};
/** By what the first bytes of a text hold. */
constexpr OtherFile kOtherTexts[] = {
    {"\"roomgraph/comparison\"", "is a comparison, and no map",
     "open it with 'roomgraph report', 'roomgraph info' or roomgraph-view"},
    {"\"roomgraph/graph\"", "is a graph, and no map",
     "open it with 'roomgraph info', or give the map that it is of"},
    {"\"roomgraph/check\"", "is what a run tells of itself, and no map",
     "open the page beside it in a browser, or give the map of the run"},
    {"\"roomgraph/site\"", "is a file of room names, and no map",
     "give it to 'roomgraph compare' as --names"},
    {"\"FeatureCollection\"", "is GeoJSON, and no map", "open it with QGIS or nav2's route server"},
    {"<graphml", "is a graph, and no map", "open it with Gephi or networkx"},
    {"<osm ", "is a map of OpenStreetMap's kind", "open it with JOSM"},
    {"<!DOCTYPE html", "is a page, and no map", "open it in a browser"},
    {"<svg ", "is a drawing, and no map", "open it in a browser, or give the map that it is of"},
    {"FLASER ", "is a log of CARMEN, and no map", "make a simplemap of it with carmen2simplemap"},
};

/** Whether the first line that is no comment is one pose of TUM's files (a time, a place, a
 *  quaternion) or KITTI's (a matrix). */
bool isTrajectory(const std::string& text) {
  std::istringstream lines(text);
  std::string line = "#";
  while (line.rfind('#', 0) == 0 && std::getline(lines, line)) {
  }
  std::istringstream numbers(line);
  std::size_t count = 0;
  for (double number = 0; numbers >> number;) ++count;
  return numbers.eof() && (count == 8 || count == 12);
}

[[noreturn]] void refuseUnknown(CheckedFile& file) {
  if (file.head().size == 0) refuse(file.name(), "is empty", "copy or save the map again");
  const auto object = peekObjectHeader(file.head());
  const bool isObject = object && isRegisteredName(object->className);
  const std::string head(reinterpret_cast<const char*>(file.head().data), file.head().size);
  if (object)
    for (const OtherFile& other : kOtherObjects)
      if (object->className == other.sign) refuse(file.name(), other.problem, other.remedy);
  const std::string remedy = "give an " + mapFormatNames();
  if (isObject) refuse(file.name(), "holds an MRPT object of class " + object->className, remedy);
  for (const OtherFile& other : kOtherTexts)
    if (head.find(other.sign) != std::string::npos)
      refuse(file.name(), other.problem, other.remedy);
  if (isTrajectory(head))
    refuse(file.name(), "is a trajectory, which shows no walls",
           "give the simplemap or the map of the run");
  refuse(file.name(), "is not a map of a known kind", remedy);
}

const MapFormat& formatOf(CheckedFile& file) {
  for (const MapFormat& format : mapFormats())
    if (format.looksLike(file)) return format;
  refuseUnknown(file);
}

/** `wantsKeyframes` tells whether the map is to have them. */
LoadedMap readMap(const std::string& name, const LoadGridOptions& options, bool wantsKeyframes) {
  CheckedFile file(name);
  const MapFormat& format = formatOf(file);
  LoadedMap result;
  std::optional<PlacedScans> scans;
  if (format.readRecording) scans = placeScans(format.readRecording(file), options);
  result.map = format.readGrid ? format.readGrid(file, options) : gridOfScans(*scans, options);
  if (scans && wantsKeyframes)
    result.keyframes = makeKeyframes(*scans, options.maxDistanceInsertion);
  result.map.source.kind = format.kind;
  result.map.source.file = name;
  if (result.map.source.sha256.empty()) result.map.source.sha256 = file.sha256();
  return result;
}

/** Tells in one line why a map cannot be read. */
LoadedMap readOrRefuse(const std::string& name, const LoadGridOptions& options,
                       bool wantsKeyframes) {
  try {
    return readMap(name, options, wantsKeyframes);
  } catch (const DataError&) {
    throw;
  } catch (const std::bad_alloc&) {
    refuse(name, "there is not enough memory for it", "give a smaller map");
  } catch (const std::exception&) {
    // MRPT's texts run over many lines and name its source files.
    refuse(name, "it cannot be read as a map", "copy or save the map again");
  }
}

}  // namespace

GreyMap loadGrid(const std::string& file, const LoadGridOptions& options) {
  return readOrRefuse(file, options, false).map;
}

LoadedMap loadMap(const std::string& file, const LoadGridOptions& options) {
  return readOrRefuse(file, options, true);
}

}  // namespace roomgraph
