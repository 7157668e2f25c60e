#include "roomgraph/graph_files/ros_map.h"

#include <charconv>
#include <cmath>

#include "roomgraph/images/png_bytes.h"
#include "text.h"

namespace roomgraph {
namespace {

constexpr std::uint8_t kUnknown = 205, kFree = 254, kOccupied = 0;

/** By State. */
constexpr std::uint8_t kGreys[] = {kUnknown, kFree, kOccupied};

/** The shortest text within half a micrometre of a length; the same in every locale. */
std::string metresText(double metres) {
  constexpr double close = 0.5e-6;
  char text[64];
  for (int digits = 0;; ++digits) {
    const auto end =
        std::to_chars(text, text + sizeof text, metres, std::chars_format::fixed, digits).ptr;
    double again = 0;
    std::from_chars(text, end, again);
    if (std::abs(again - metres) <= close || digits == 6)
      return again == 0 ? "0" : std::string(text, end);
  }
}

std::uint8_t greyOf(State state) { return kGreys[std::size_t(state)]; }

}  // namespace

std::string mapPgm(const Grid& grid) {
  const GridFrame& frame = grid.frame;
  std::string bytes =
      "P5\n" + std::to_string(frame.width) + " " + std::to_string(frame.height) + "\n255\n";
  bytes.reserve(bytes.size() + frame.cellCount());
  for (int y = frame.height; y-- > 0;)
    for (int x = 0; x < frame.width; ++x) bytes += char(greyOf(grid.at({x, y})));
  return bytes;
}

std::string mapPng(const Grid& grid) {
  PaletteImage image;
  image.width = grid.frame.width, image.height = grid.frame.height;
  for (const std::uint8_t grey : kGreys) image.palette.push_back({grey, grey, grey});
  image.indices.reserve(grid.cells.size());
  for (int y = image.height; y-- > 0;)
    for (int x = 0; x < image.width; ++x) image.indices.push_back(std::uint8_t(grid.at({x, y})));
  return pngBytes(image);
}

std::string rosMapYaml(const GridFrame& frame, const std::string& picture, const Transform2D& pose,
                       RosMapMode mode) {
  const Point origin = pose(frame.origin);
  const bool isScale = mode == RosMapMode::scale;
  return kRosMapMark + ("\nimage: " + quotedText(picture)) +
         "\nmode: " + (isScale ? "scale" : "trinary") +
         "\nresolution: " + numberText(frame.resolution) + "\norigin: [" + metresText(origin.x) +
         ", " + metresText(origin.y) + ", " + numberText(pose.phi) + "]\nnegate: 0\n" +
         (isScale ? "occupied_thresh: 1.0\nfree_thresh: 0.0\n"
                  : "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

}  // namespace roomgraph
