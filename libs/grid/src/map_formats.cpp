#include "roomgraph/grid/map_formats.h"

#include "read_bare_image.h"
#include "read_gridmap.h"
#include "read_ros_map.h"
#include "read_simplemap.h"

namespace roomgraph {
namespace {

/** "a, b or c". */
std::string listed(std::string (*textOf)(const MapFormat&)) {
  const std::vector<MapFormat>& formats = mapFormats();
  std::string text;
  for (const MapFormat& format : formats) {
    if (&format != &formats.front()) text += &format == &formats.back() ? " or " : ", ";
    text += textOf(format);
  }
  return text;
}

}  // namespace

const std::vector<MapFormat>& mapFormats() {
  static const std::vector<MapFormat> formats = {
      {"gridmap", {".gridmap"}, "MRPT grid map", isGridmap, readGridmap},
      {"simplemap", {".simplemap"}, "MRPT simplemap", isSimplemap, readSimplemap},
      {"ros_map", {".yaml", ".yml"}, "ROS map", isRosMap, readRosMap},
      {"image", {".png", ".pgm", ".bmp", ".jpg", ".jpeg"}, "picture", isBareImage, readBareImage},
  };
  return formats;
}

std::string mapFormatNames() {
  return listed([](const MapFormat& format) { return std::string(format.name); });
}

std::string mapFormatsText() {
  return listed([](const MapFormat& format) {
    std::string text = format.name;
    const char* separator = " (";
    for (const char* extension : format.extensions)
      text += separator + std::string(extension), separator = ", ";
    return text + ")";
  });
}

}  // namespace roomgraph
