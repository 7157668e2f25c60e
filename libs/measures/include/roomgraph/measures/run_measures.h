#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/measures/Measure.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/PlacedRuns.h"

namespace roomgraph {

// Ours
// In:   the runs of a site, placed
// Out:  Measure
// Next: compareRuns

/** Per run: `coverage`, of all places that two runs have seen free the share that this one has seen
 *  free. Of runs with the same map one counts. Meaningful with three maps and 10 m2. Support in
 *  cells. O(runs * cells of the site). */
std::vector<Measure> coverageOf(const PlacedRuns& site,
                                const std::vector<std::vector<PairBend>>& bends);

/** Of one run: `bend`, its mean bend against the others, weighted by trust [m]; copies of its map
 *  are no others, unless there are no more. Support in wall points. */
Measure bendOf(const std::vector<std::vector<PairBend>>& bends, const std::vector<double>& trust,
               std::size_t run);

/** Of one run: `axis_deviation`, see axisDeviation [deg]. Support in wall points; no interval, as
 *  the others have no part in it. */
Measure axisDeviationOf(const PreparedRun& run);

/** Of one run: median ("wall_distance") and 90th percentile ("wall_distance_p90") of the distances
 *  of its walls to those of the others, weighted by trust. Support in wall points. */
std::vector<Measure> wallMeasuresOf(const PlacedRuns& site, std::size_t run);

/** Per run two measures by matchRooms. `rooms_matched`: of the rooms of the others (weighted by
 *  trust) whose middle it has seen free or that match one of its own, the share that match; support
 *  in rooms. `room_coverage`: of the area of all rooms of the others, seen or not, the share in
 *  rooms that match one of its own; support in m2. No value where there is none. O(runs^2 * cells
 *  of the site). */
std::vector<std::vector<Measure>> roomMeasuresOf(const PlacedRuns& site, const ForEach& forEach);

}  // namespace roomgraph
