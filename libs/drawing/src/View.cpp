#include "View.h"

#include <algorithm>

namespace roomgraph {
namespace {

constexpr int kMaxPx = 1600;    // of the longer side
constexpr int kRoomyPx = 1200;  // magnified maps stay under this
constexpr int kMaxMagnify = 4;  // but very small maps are brought up to kSmallPx
constexpr int kSmallPx = 640;

struct Bounds {
  Cell low, high;
};

/** The first and last row and column that hold a known cell. */
Bounds knownBounds(const Grid& grid) {
  const int width = grid.frame.width, height = grid.frame.height;
  Bounds bounds{{width, height}, {-1, -1}};
  for (int y = 0; y < height; ++y) {
    const State* row = grid.cells.data() + std::size_t(y) * std::size_t(width);
    const auto isKnown = [](State s) { return s != State::unknown; };
    const int first = int(std::find_if(row, row + width, isKnown) - row);
    if (first == width) continue;
    int last = width - 1;
    while (!isKnown(row[last])) --last;
    bounds = {{std::min(bounds.low.x, first), std::min(bounds.low.y, y)},
              {std::max(bounds.high.x, last), y}};
  }
  if (bounds.high.y < 0) bounds = {{0, 0}, {width - 1, height - 1}};
  return bounds;
}

}  // namespace

Point View::px(Point map) const {
  const double scale = pxPerMetre();
  return {(map.x - frame.origin.x - first.x * frame.resolution) * scale,
          heightPx() - (map.y - frame.origin.y - first.y * frame.resolution) * scale};
}

View viewOf(const Grid& grid) {
  const Bounds known = knownBounds(grid);
  View view;
  view.frame = grid.frame;
  view.columns = std::max(1, known.high.x - known.low.x + 1);
  view.rows = std::max(1, known.high.y - known.low.y + 1);
  const int margin = 2 + std::max(view.columns, view.rows) / 60;
  view.first = {known.low.x - margin, known.low.y - margin};
  view.columns += 2 * margin;
  view.rows += 2 * margin;
  const int longer = std::max(view.columns, view.rows);
  view.reduce = (longer + kMaxPx - 1) / kMaxPx;
  view.magnify = std::clamp(kRoomyPx / longer, 1, std::max(kMaxMagnify, kSmallPx / longer));
  // The lowest row of pixels is a whole one, so that y is counted from a cell's edge.
  view.rows = view.imageHeight() * view.reduce;
  return view;
}

}  // namespace roomgraph
