#include "passage_evidence.h"

#include <algorithm>
#include <cmath>

#include "RegionGroups.h"
#include "goes_on.h"

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
  const bool isOne = 2 * free < options.corridorDoor && isInWall(grid, border.from, border.to);
  const double besideDoors = narrowness(2 * free, options.maxWidth);
  const double likeADoor = isOne ? besideDoors : std::sqrt(narrowness(free, beside) * besideDoors);
  const bool isNarrow =
      isOne || (narrowness(free, options.maxRatio * beside) > 0 && besideDoors > 0);
  const double confidence = likeADoor * shareOfNarrowestRoom(2 * free, options.minRoomWidth);
  return {confidence * border.wallEnds / 2, reasonOf(grid, border, isNarrow)};
}

}  // namespace roomgraph
