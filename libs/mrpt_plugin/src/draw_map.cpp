#include "draw_map.h"

#include <algorithm>

#include "roomgraph/mrpt_plugin/colours.h"

namespace roomgraph {
namespace {

std::uint8_t greyOf(State state) {
  switch (state) {
    case State::free:
      return kFreeGrey;
    case State::occupied:
      return kOccupiedGrey;
    case State::unknown:
      break;
  }
  return kUnknownGrey;
}

}  // namespace

viz::CTexturedPlane::Ptr drawMap(const Grid& map, Point anchor) {
  const GridFrame& frame = map.frame;
  const int step = (std::max(frame.width, frame.height) + kMostTexels - 1) / kMostTexels;
  const int width = (frame.width + step - 1) / step, height = (frame.height + step - 1) / step;
  mrpt::img::CImage image(unsigned(width), unsigned(height), mrpt::img::CH_GRAY);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at<std::uint8_t>(unsigned(x), unsigned(y)) = 255;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      auto& texel = image.at<std::uint8_t>(unsigned(x / step), unsigned(y / step));
      texel = std::min(texel, greyOf(map.at({x, y})));
    }
  const Point low = frame.origin - anchor;
  const double side = frame.resolution * step;
  auto plane = viz::CTexturedPlane::Create(float(low.x), float(low.x + width * side), float(low.y),
                                           float(low.y + height * side));
  plane->setName("map");
  plane->assignImage(std::move(image));
  return plane;
}

}  // namespace roomgraph
