#include "write_map.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>
#include <png.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "make_mrpt_grid.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

[[noreturn]] void refuse(const std::string& file) {
  throw DataError(file + ": cannot be written; check the directory and the space left");
}

void writeObject(const mrpt::serialization::CSerializable& object, const std::string& file,
                 int compression) {
  mrpt::io::CFileGZOutputStream out;
  if (!out.open(file, compression)) refuse(file);
  mrpt::serialization::archiveFrom(out) << object;
}

/** The levels of ROS' map_saver, top row first. */
std::vector<png_byte> rosPixels(const GreyMap& map) {
  constexpr png_byte kRosFree = 254, kRosUnknown = 205, kRosOccupied = 0;
  std::vector<png_byte> pixels;
  pixels.reserve(map.grey.size());
  for (int y = map.frame.height - 1; y >= 0; --y)
    for (int x = 0; x < map.frame.width; ++x) {
      const double occupied = 1 - map.grey[map.frame.index({x, y})] / 255.0;
      pixels.push_back(occupied > map.occupiedAbove ? kRosOccupied
                       : occupied < map.freeBelow   ? kRosFree
                                                    : kRosUnknown);
    }
  return pixels;
}

}  // namespace

void writeGridmap(const GreyMap& map, const std::string& file) {
  writeObject(makeMrptGrid(map), file, 9);
}

void writeSimplemap(const mrpt::maps::CSimpleMap& frames, const std::string& file,
                    int compression) {
  writeObject(frames, file, compression);
}

void writeRosMap(const GreyMap& map, const std::string& stem) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(map.frame.width);
  image.height = png_uint_32(map.frame.height);
  image.format = PNG_FORMAT_GRAY;
  const auto pixels = rosPixels(map);
  if (!png_image_write_to_file(&image, (stem + ".png").c_str(), 0, pixels.data(), 0, nullptr))
    refuse(stem + ".png");
  std::ofstream yaml(stem + ".yaml");
  yaml << "image: " << std::filesystem::path(stem).filename().string() << ".png\n"
       << "mode: trinary\n"
       << "resolution: " << map.frame.resolution << "\n"
       << "origin: [" << map.frame.origin.x << ", " << map.frame.origin.y << ", 0]\n"
       << "negate: 0\n"
       << "occupied_thresh: 0.65\n"
       << "free_thresh: 0.196\n";
  if (!yaml.flush()) refuse(stem + ".yaml");
}

}  // namespace roomgraph
