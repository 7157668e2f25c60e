#include "roomgraph/graph_files/ros_map.h"

#include <charconv>
#include <cmath>

#include "roomgraph/images/pgm_bytes.h"
#include "roomgraph/images/png_bytes.h"
#include "text.h"

namespace roomgraph {
namespace {

/** Of what is unknown, free and occupied, by State. */
constexpr std::uint8_t kGreys[] = {205, 254, 0};

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

}  // namespace

std::string mapPgm(const Grid& grid) {
  std::vector<std::uint8_t> greys;
  greys.reserve(grid.cells.size());
  for (int y = grid.frame.height; y-- > 0;)
    for (int x = 0; x < grid.frame.width; ++x)
      greys.push_back(kGreys[std::size_t(grid.at({x, y}))]);
  return pgmBytes(greys, grid.frame.width, grid.frame.height);
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
