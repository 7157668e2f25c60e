#pragma once
#include <optional>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

// Ours, beside the paper's measure
// In:   the rooms of two graphs in one frame
// Out:  which room is which
// Next: stability

struct MatchedRooms {
  RoomId base, other;
  double overlap = 0;  ///< intersection over union, more than a half
};

/** Finds each room of `base` again in `other`: two rooms are the same where their common area is
 *  more than half of that which they cover together. No room can be the same as two others as long
 *  as the rooms of a graph do not overlap. Areas are counted in cells of `frame` whose centre lies
 *  in a room's polygon; a room without any is not found. Ordered by base room. O(cells). */
std::vector<MatchedRooms> matchRooms(const std::vector<GraphRoom>& base,
                                     const std::vector<GraphRoom>& other, const GridFrame& frame);

}  // namespace roomgraph
