#pragma once
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// In:   two maps, and poses at which one may lie in the other
// Out:  how much of them is drawn by the same hand, cell by cell
// Next: relateMaps

/** How many of the edge cells of two maps are the same cells. */
struct SharedEdges {
  double ofA = 0, ofB = 0;  ///< share of those that lie where the other map lies, 0 to 1
};

/** The edge cells that two maps share where one lies on the cells of the other: near one of `poses`
 *  (a <- b), turned by a quarter or none and shifted by whole cells; the most of all of these.
 *  Nothing for maps of other cells, or where the pose is no such turn. O(poses * cells). */
SharedEdges sharedEdges(const DrawnEdges& a, const DrawnEdges& b,
                        const std::vector<Transform2D>& poses);

/** Whether two maps are edits of one picture: crops of it, turned, with other thresholds, or with
 *  walls erased or added. Maps of two drives are not, however well they agree. See sharedEdges. */
bool areEdits(const DrawnEdges& a, const DrawnEdges& b, const std::vector<Transform2D>& poses);

/** Whether two maps are the same, cell by cell and wall by wall. */
bool areIdentical(const WallMap& l, const WallMap& r);

}  // namespace roomgraph
