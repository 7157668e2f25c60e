#include "roomgraph/align/mirrored.h"

#include <algorithm>
#include <tuple>

#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

void mirrorCells(WallMap& map) {
  GridFrame& frame = map.frame;
  for (int y = 0; y < frame.height; ++y) {
    const auto row = map.states.begin() + std::ptrdiff_t(frame.index({0, y}));
    std::reverse(row, row + frame.width);
  }
  for (std::uint32_t& cell : map.freeCells) {
    const auto width = std::uint32_t(frame.width);
    cell = cell - cell % width + (width - 1 - cell % width);
  }
  frame.origin.x = -(frame.origin.x + frame.width * frame.resolution);
}

void mirrorWalls(WallMap& map) {
  for (WallPoint& wall : map.walls) wall.place.x = -wall.place.x, wall.normal.x = -wall.normal.x;
  const auto key = [&](const WallPoint& wall) {
    return std::make_tuple(map.frame.index(map.frame.cellAt(wall.place)), octantOf(wall.normal),
                           wall.place.x, wall.place.y);
  };
  std::sort(map.walls.begin(), map.walls.end(),
            [&](const WallPoint& l, const WallPoint& r) { return key(l) < key(r); });
  map.patches = wallPatches(map.walls);
}

/** Bin k holds the turns from k to k + 1 steps, so that of half a turn less these is k + 1 from the
 *  other end. */
void mirrorTurns(std::vector<double>& turns) {
  std::vector<double> mirrored(turns.size());
  const std::size_t bins = turns.size();
  for (std::size_t k = 0; k < bins; ++k) mirrored[(bins + bins / 2 - 1 - k) % bins] = turns[k];
  turns = std::move(mirrored);
}

}  // namespace

WallMap mirrored(const WallMap& map) {
  WallMap image = map;
  image.edges = {};
  mirrorCells(image);
  mirrorWalls(image);
  mirrorTurns(image.turns);
  if (!map.isBare()) addLookUp(image);
  return image;
}

}  // namespace roomgraph
