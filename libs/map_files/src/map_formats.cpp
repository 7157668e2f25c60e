#include "roomgraph/map_files/map_formats.h"

#include "readers.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/images/read_image.h"
#include "roomgraph/scans/read_simplemap.h"

namespace roomgraph {
namespace {

/** "a, b or c". */
std::string namesOf(std::string (*textOf)(const MapFormat&)) {
  return alternatives(mapped(mapFormats(), textOf));
}

/** A picture without a yaml, at options.resolution. */
GreyMap readBareImage(CheckedFile& file, const LoadGridOptions& options) {
  GreyMap map;
  readImage(file, map);
  map.frame.resolution = options.resolution;
  // Common pictures of maps draw the unknown at 205 to 230, and free space near white.
  map.occupiedAbove = 0.65;
  map.freeBelow = 0.095;
  if (!options.isResolutionGiven)
    map.notes.push_back({"assumed_resolution",
                         formatted("a picture does not say how large it is: read at %g m per cell, "
                                   "the default of --resolution",
                                   options.resolution)});
  return map;
}

}  // namespace

const std::vector<MapFormat>& mapFormats() {
  static const std::vector<MapFormat> formats = {
      {"gridmap", {".gridmap"}, "MRPT grid map", isGridmap, readGridmap, nullptr},
      {"simplemap", {".simplemap"}, "MRPT simplemap", isSimplemap, nullptr, readSimplemap},
      {"metric_map", {".mm"}, "MOLA metric map", isMetricMap, readMetricMap, nullptr},
      {"rtabmap", {".db"}, "rtabmap database", isRtabmap, readRtabmap, nullptr},
      {"ros_map", {".yaml", ".yml"}, "ROS map", isRosMap, readRosMap, nullptr},
      {"image",
       {".png", ".pgm", ".bmp", ".jpg", ".jpeg"},
       "picture",
       [](CheckedFile& file) { return isImage(file.head()); },
       readBareImage,
       nullptr},
  };
  return formats;
}

std::string mapFormatNames() {
  return namesOf([](const MapFormat& format) { return std::string(format.name); });
}

std::string mapFormatsText() {
  return namesOf([](const MapFormat& format) {
    std::string text = format.name;
    const char* separator = " (";
    for (const char* extension : format.extensions)
      text += separator + std::string(extension), separator = ", ";
    return text + ")";
  });
}

std::string mapStem(const std::string& mapFile) {
  std::string name = fileName(mapFile);
  for (const std::string end : {".gz", ".zst"})
    if (endsWith(name, end)) name.resize(name.size() - end.size());
  for (const MapFormat& format : mapFormats())
    for (const std::string end : format.extensions)
      if (endsWith(name, end)) return name.substr(0, name.size() - end.size());
  return name;
}

}  // namespace roomgraph
