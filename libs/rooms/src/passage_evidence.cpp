#include "passage_evidence.h"

#include <algorithm>
#include <cmath>

#include "RegionGroups.h"

namespace roomgraph {
namespace {

/** By how much it is narrower: 0 where it is not. */
double narrowness(double width, double beside) {
  return width < beside * (1 - kSameWidth) ? 1 - width / beside : 0;
}

/** Gaps beside furniture are narrower than the narrowest room, and few doors are. */
double shareOfNarrowestRoom(double width, double narrowest) {
  return width < narrowest ? width / narrowest : 1;
}

/** Whether wall, or what nobody has seen, goes on beyond `end` in line with the opening. */
bool goesOn(const Grid& grid, Point end, Point other) {
  const double width = distance(end, other), step = grid.frame.resolution;
  const Point out = (step / width) * (end - other);
  for (int i = 1; i * step <= width / 2 * (1 + kSameWidth); ++i)
    if (grid.isFree(end + double(i) * out)) return false;
  return true;
}

PassageReason reasonOf(const Grid& grid, const RegionBorder& border, bool isNarrow) {
  if (border.wallEnds < 2) return PassageReason::unseenSide;
  if (!isNarrow) return PassageReason::mouth;
  const int walls = (goesOn(grid, border.from, border.to) ? 1 : 0) +
                    (goesOn(grid, border.to, border.from) ? 1 : 0);
  return walls == 2   ? PassageReason::wallOnBothSides
         : walls == 1 ? PassageReason::wallOnOneSide
                      : PassageReason::narrowing;
}

}  // namespace

PassageEvidence passageEvidence(const Grid& grid, const RegionBorder& border, double radius,
                                const SplitAtDoorsOptions& options) {
  const double halfCell = grid.frame.resolution / 2;
  const double free = std::max(0.0, border.clearance - halfCell), beside = radius - halfCell;
  const double likeADoor =
      std::sqrt(narrowness(free, beside) * narrowness(2 * free, options.maxWidth));
  const bool isNarrow =
      narrowness(free, options.maxRatio * beside) > 0 && narrowness(2 * free, options.maxWidth) > 0;
  const double confidence = likeADoor * shareOfNarrowestRoom(2 * free, options.minRoomWidth);
  return {confidence * border.wallEnds / 2, reasonOf(grid, border, isNarrow)};
}

}  // namespace roomgraph
