#include "roomgraph/map_files/load_grid.h"

#include <algorithm>
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
/** By what the first bytes of a file hold; what holds others' signs comes first. */
constexpr OtherFile kOtherFiles[] = {
    {"SQLite format 3", "is an archive of roomgraph, and no map",
     "open it with 'roomgraph archive'"},
    {"PK\x03\x04", "is a zip file, and no map",
     "open it with evo_res where 'roomgraph compare' has written it, or unpack it"},
    {"\"roomgraph/comparison\"", "is a comparison, and no map",
     "open it with 'roomgraph report', 'roomgraph info' or roomgraph-view"},
    {"\"roomgraph/graph\"", "is a graph, and no map",
     "open it with 'roomgraph info', or give the map that it is of"},
    {"\"roomgraph/check\"", "is what a run tells of itself, and no map",
     "open the page beside it in a browser, or give the map of the run"},
    {"\"roomgraph/site\"", "is a file of room names, and no map",
     "give it to 'roomgraph compare' as --names"},
    {"\"roomgraph/", "is a result of roomgraph, and no map",
     "open it in an editor, or give the map that it is of"},
    {"\"FeatureCollection\"", "is GeoJSON, and no map", "open it with QGIS or nav2's route server"},
    {"<graphml", "is a graph, and no map", "open it with Gephi or networkx"},
    {"<osm ", "is a map of OpenStreetMap's kind", "open it with JOSM"},
    {"<!DOCTYPE html", "is a page, and no map", "open it in a browser"},
    {"<svg ", "is a drawing, and no map", "open it in a browser, or give the map that it is of"},
    {"<testsuites", "is the verdict of a gate, and no map", "give it to a CI system as JUnit's"},
    {"## The gate ", "is the summary of a gate, and no map", "open it with an editor"},
    {" maps compared\n", "is a summary of a comparison, and no map", "open it with an editor"},
    {"VERTEX_SE2 ", "is a graph of poses, and no map", "open it with g2o_viewer"},
    {"[maps.\"", "is a session of the viewer 'maps', and no map", "open it with 'maps'"},
    {"root_frame: ", "tells where a map lies in its site, and is none", "give the map beside it"},
    {"[load_grid]", "is a file of options, and no map", "give it as --config"},
    {"{\"site\":", "is a list of tasks, and no map", "give its folder to 'roomgraph task'"},
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

/** Whether the first two lines have the same number of commas, and more than one. */
bool isTable(const std::string& text) {
  std::istringstream lines(text);
  std::string heading, row;
  std::getline(lines, heading);
  std::getline(lines, row);
  const auto commas = std::count(heading.begin(), heading.end(), ',');
  return commas > 1 && std::count(row.begin(), row.end(), ',') == commas;
}

[[noreturn]] void refuseUnknown(CheckedFile& file) {
  if (file.head().size == 0) refuse(file.name(), "is empty", kSaveMapAgain);
  const auto object = peekObjectHeader(file.head());
  const bool isObject = object && isRegisteredName(object->className);
  const std::string head = file.head().text();
  if (object)
    for (const OtherFile& other : kOtherObjects)
      if (object->className == other.sign) refuse(file.name(), other.problem, other.remedy);
  const std::string remedy = "give an " + mapFormatNames();
  if (isObject) refuse(file.name(), "holds an MRPT object of class " + object->className, remedy);
  for (const OtherFile& other : kOtherFiles)
    if (head.find(other.sign) != std::string::npos)
      refuse(file.name(), other.problem, other.remedy);
  if (isTrajectory(head))
    refuse(file.name(), "is a trajectory, which shows no walls",
           "give the simplemap or the map of the run");
  if (isTable(head))
    refuse(file.name(), "is a table, and no map", "open it with a spreadsheet program");
  refuse(file.name(), "is not a map of a known kind", remedy);
}

const MapFormat& formatOf(CheckedFile& file) {
  for (const MapFormat& format : mapFormats())
    if (format.looksLike(file)) return format;
  refuseUnknown(file);
}

/** Notes on options that this kind of map has no use for. */
Notes unusedOptions(const MapFormat& format, const LoadGridOptions& options) {
  const std::string kind = format.kind;
  Notes notes;
  if (!options.layer.empty() && kind != "metric_map")
    notes.push_back({kUnusedOption, "--layer is for metric maps (.mm): it was not used", {}});
  if (options.isResolutionGiven && format.readGrid && kind != "image")
    notes.push_back({kUnusedOption,
                     "--resolution is for pictures and scans, not for maps that tell their own: it "
                     "was not used",
                     {}});
  return notes;
}

LoadedMap readMap(const std::string& name, const LoadGridOptions& options, bool wantsKeyframes) {
  CheckedFile file(name);
  const MapFormat& format = formatOf(file);
  LoadedMap result;
  std::optional<PlacedScans> scans;
  if (format.readRecording) scans = placeScans(format.readRecording(file), options);
  result.map = format.readGrid ? format.readGrid(file, options) : gridOfScans(*scans, options);
  if (!result.map.grey.empty() && !result.map.frame.isSane())
    refuse(name, "it lies over 10000 km off", "save it in a frame that begins near it");
  if (scans && wantsKeyframes)
    result.keyframes = makeKeyframes(*scans, options.maxDistanceInsertion);
  const Notes unused = unusedOptions(format, options);
  result.map.notes.insert(result.map.notes.begin(), unused.begin(), unused.end());
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
    refuse(name, "it cannot be read as a map", kSaveMapAgain);
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
