#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/base/PairTable.h"
#include "roomgraph/measures/Measure.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Site.h"
#include "wall_distances.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, placed
// Out:  Measure
// Next: compareRuns

/** Per run: `coverage`, of all places that two runs have seen free the share that this one has seen
 *  free. Of runs with the same map one counts. Meaningful with three maps and 10 m2. Support in
 *  cells. O(runs * cells of the site). */
std::vector<Measure> coverageOf(const Site& site, const PairBends& bends);

/** Of one run: `bend`, its mean bend against the others, weighted by trust [m]; copies of its map
 *  are no others, unless there are no more. Support in wall points. */
Measure bendOf(const PairBends& bends, const Trust& trust, std::size_t run);

/** Of one run: `axis_deviation`, see axisDeviation [deg]. Support in wall points; no interval, as
 *  the others have no part in it. */
Measure axisDeviationOf(const Run& run);

/** How far the walls of each run lie from those of each other one. */
using DistanceTable = DirectedTable<WallDistances>;

/** O(runs^2 * walls). */
DistanceTable distancesOf(const Site& site, const ForEach& forEach);

/** Of one run: median ("wall_distance") and 90th percentile ("wall_distance_p90") of the distances
 *  of its walls to those of the others, weighted by trust. Support in wall points. */
std::vector<Measure> wallMeasuresOf(const DistanceTable& distances, const Trust& trust,
                                    std::size_t run);

/** Of a pair: `bend` [m], `followed`, and `wall_distance_mean`, `wall_distance` and
 *  `wall_distance_p90` over the walls of both [m]. Meaningful with 300 wall points. */
std::vector<Measure> wallMeasuresOfPair(const PairBend& bend, const DistanceTable& distances,
                                        std::size_t a, std::size_t b);

/** Per run two measures by matchRooms. `rooms_matched`: of the rooms of the others (weighted by
 *  trust) whose middle it has seen free or that match one of its own, the share that match; support
 *  in rooms. `room_coverage`: of the area of all rooms of the others, seen or not, the share in
 *  rooms that match one of its own; support in m2. No value where there is none. O(runs^2 * cells
 *  of the site). */
std::vector<std::vector<Measure>> roomMeasuresOf(const Site& site, const Trust& trust,
                                                 const ForEach& forEach);

}  // namespace roomgraph
