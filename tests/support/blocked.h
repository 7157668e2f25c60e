#pragma once
#include <string>

#include "roomgraph/grid/Grid.h"

namespace roomgraph::test {

/** " at (x, y)", for messages. */
std::string textOf(Point p);

/** Whether what lies beyond the border counts as blocked: only where the map knows unknown cells.
 */
bool isBlockedOutside(const Grid& grid);

/** Distance to the nearest centre of a cell that is not free, or `limit`. */
double distanceToBlocked(const Grid& grid, bool outsideIsBlocked, Point p, double limit);

}  // namespace roomgraph::test
