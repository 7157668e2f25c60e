#include "keep_seen.h"

#include <cstdlib>

#include "FloorPlan.h"

namespace roomgraph {
namespace {

bool blocksSight(std::uint8_t level) { return level == grey::kWall || level == grey::kAddedWall; }

class Eye {
 public:
  explicit Eye(const GreyMap& map) : map_(map), seen_(map) {
    seen_.grey.assign(map.grey.size(), grey::kUnknown);
  }

  void lookAround(Cell from, int range) {
    for (int d = -range; d <= range; ++d) {
      lookAlong(from, {from.x + d, from.y - range});
      lookAlong(from, {from.x + d, from.y + range});
      lookAlong(from, {from.x - range, from.y + d});
      lookAlong(from, {from.x + range, from.y + d});
    }
  }

  GreyMap take() { return std::move(seen_); }

 private:
  /** Bresenham's line up to the first cell that blocks the sight. */
  void lookAlong(Cell from, Cell to) {
    const int dx = std::abs(to.x - from.x), dy = -std::abs(to.y - from.y);
    const int stepX = from.x < to.x ? 1 : -1, stepY = from.y < to.y ? 1 : -1;
    int error = dx + dy;
    for (Cell c = from; map_.frame.contains(c);) {
      const std::size_t i = map_.frame.index(c);
      seen_.grey[i] = map_.grey[i];
      if (blocksSight(map_.grey[i]) || (c.x == to.x && c.y == to.y)) return;
      const int twice = 2 * error;
      if (twice >= dy) {
        error += dy;
        c.x += stepX;
      }
      if (twice <= dx) {
        error += dx;
        c.y += stepY;
      }
    }
  }

  const GreyMap& map_;
  GreyMap seen_;
};

}  // namespace

GreyMap keepSeen(const GreyMap& map, const std::vector<Point>& places, int range) {
  Eye eye(map);
  for (const Point& place : places) eye.lookAround(map.frame.cellAt(place), range);
  return eye.take();
}

}  // namespace roomgraph
