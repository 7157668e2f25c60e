#pragma once
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {

// Ours: a mode filter over the motions of the places
// In:   the places of one thing, and where each was carried by itself
// Out:  the same, without places that jump away from those beside them
// Next: MarkedFile::write

/** Where a map has a place twice, as beside a break, neighbours may have been carried to one copy
 *  and to the other, and a zone would be torn to shreds. A place of which more than half of its
 *  neighbours (the eight nearest) say that it lies elsewhere, and agree where, follows the nearest
 *  of these; of a thing that lies across a break, each side stays where it is. Returns which ones
 *  have moved. O(places^2). */
std::vector<bool> keepShape(const std::vector<Transform2D>& were, std::vector<Transform2D>& poses);

}  // namespace roomgraph
