#include "roomgraph/repair/CellVotes.h"

#include <cstdlib>

namespace roomgraph {

void CellVotes::addBeam(Point eye, Point end) {
  Cell at = frame_.cellAt(eye);
  const Cell last = frame_.cellAt(end);
  const int width = std::abs(last.x - at.x), height = -std::abs(last.y - at.y);
  const int stepX = at.x < last.x ? 1 : -1, stepY = at.y < last.y ? 1 : -1;
  for (int error = width + height; at.x != last.x || at.y != last.y;) {
    ++votes_[frame_.index(at)].passes;
    const int twice = 2 * error;
    if (twice >= height) error += height, at.x += stepX;
    if (twice <= width) error += width, at.y += stepY;
  }
  ++votes_[frame_.index(last)].hits;
}

}  // namespace roomgraph
