#pragma once
#include "MeasuredValue.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/base/PairTable.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   the rooms of the runs of a site, placed
// Out:  MeasuredValue
// Next: measureSite

/** How many rooms of another run this one could have, and how many it has. */
struct RoomCount {
  double visible = 0;                ///< whose middle it has seen free, and those that it has
  double matched = 0;                ///< by matchRooms
  double area = 0, matchedArea = 0;  ///< of all rooms of the other, and of those it has [m2]
};

/** Of each run, the rooms of the others. */
using RoomCounts = DirectedTable<RoomCount>;

/** Of `pairs` of runs. O(pairs * cells of the site). */
RoomCounts roomCounts(const Site& site, const std::vector<PairOfThings>& pairs,
                      const ForEach& forEach);

/** `rooms_matched`: of the rooms of the others (weighted by trust) whose middle it has seen free or
 *  that match one of its own, the share that match; support in rooms. No value without any. */
MeasuredValue roomsMatchedOf(const RoomCounts& counts, const Trust& trust, std::size_t run);

/** `room_coverage`: of the area of all rooms of the others, seen or not, the share in rooms that
 *  match one of its own; support in m2. No value without any. */
MeasuredValue roomCoverageOf(const RoomCounts& counts, const Trust& trust, std::size_t run);

}  // namespace roomgraph
