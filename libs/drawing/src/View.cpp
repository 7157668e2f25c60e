#include "View.h"

#include <algorithm>

#include "roomgraph/grid/CellBox.h"

namespace roomgraph {
namespace {

/** The palette index of unknown, free and occupied: the larger one wins a pixel. */
constexpr std::uint8_t kIndex[] = {0, 1, 2};
static_assert(int(State::unknown) == 0 && int(State::free) == 1 && int(State::occupied) == 2);

constexpr int kMaxPx = 1600;    // of the longer side
constexpr int kRoomyPx = 1200;  // magnified maps stay under this
constexpr int kMaxMagnify = 4;  // but very small maps are brought up to kSmallPx
constexpr int kSmallPx = 640;

}  // namespace

Colour stateColour(State state) {
  constexpr Colour colours[] = {{198, 203, 211}, {255, 255, 255}, {58, 62, 68}};
  return colours[kIndex[std::size_t(state)]];
}

PaletteImage backdrop(const Grid& grid, const View& view) {
  PaletteImage image;
  image.width = view.imageWidth();
  image.height = view.imageHeight();
  image.palette = {stateColour(State::unknown), stateColour(State::free),
                   stateColour(State::occupied)};
  image.indices.assign(std::size_t(image.width) * std::size_t(image.height), 0);
  const int firstX = std::max(0, view.first.x), firstY = std::max(0, view.first.y);
  const int endX = std::min(grid.frame.width, view.first.x + view.columns);
  const int endY = std::min(grid.frame.height, view.first.y + view.rows);
  for (int y = firstY; y < endY; ++y) {
    const State* row = grid.cells.data() + grid.frame.index({0, y});
    const int fromBottom = (y - view.first.y) / view.reduce;
    std::uint8_t* out = image.indices.data() + std::size_t(fromBottom) * std::size_t(image.width);
    // Counted rather than divided: this line runs for every cell of the map.
    int column = (firstX - view.first.x) / view.reduce;
    int left = view.reduce - (firstX - view.first.x) % view.reduce;
    for (int x = firstX; x < endX; ++x) {
      out[column] = std::max(out[column], kIndex[std::size_t(row[x])]);
      if (--left > 0) continue;
      ++column;
      left = view.reduce;
    }
  }
  return image;
}

Point View::px(Point map) const {
  const double scale = pxPerMetre();
  return {(map.x - frame.origin.x - first.x * frame.resolution) * scale,
          heightPx() - (map.y - frame.origin.y - first.y * frame.resolution) * scale};
}

View viewOf(const Grid& grid) {
  CellBox known = knownCells(grid);
  if (known.isEmpty()) known = {{0, 0}, {grid.frame.width - 1, grid.frame.height - 1}};
  View view;
  view.frame = grid.frame;
  view.columns = std::max(1, known.width());
  view.rows = std::max(1, known.height());
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
