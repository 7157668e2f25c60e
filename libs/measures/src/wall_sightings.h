#pragma once
#include <cstddef>
#include <vector>

#include "MeasuredValue.h"
#include "roomgraph/align/WallPatches.h"
#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/MapPairs.h"
#include "roomgraph/relate/Site.h"
#include "roomgraph/relate/sight_walls.h"
#include "run_measures.h"

namespace roomgraph {

// In:   the runs of a site, placed, and how each two of them lie in each other, place by place
// Out:  which walls of a run are there in others
// Next: measureSite

/** Which walls of each run are there in the others, and how far off. */
struct SightingTable {
  DirectedTable<std::vector<WallSighting>> in;  ///< of each wall point of a run, in another one
  DistanceTable distances;
  std::vector<std::vector<bool>> isStraight;  ///< of each of a run: it is of 2 m of straight wall
  std::vector<const WallPatches*> patches;    ///< of the walls of each run
  std::vector<bool> hasScans;                 ///< of each run
  std::vector<double> spacing;                ///< of the wall points of each run [m]
};

/** Of all pairs, see sightWalls and wallDistances. O(pairs * walls). */
SightingTable wallSightings(const Site& site, const MapPairs& pairs, const ForEach& forEach);

/** Of one run: `walls_missing`, of the straight walls of each other run that a third one has, too,
 *  and none denies, and of which this one has seen the place, the share that it has not: it shows
 *  free space there, or only up to there. Where it has less than half of the points of the walls
 *  found in both, as if thinned to dots, the share of them that is gone counts, too. Furniture,
 *  which moves, is seldom as straight. Weighted by trust. Edits of one picture are one voice;
 *  beside a run with scans, others with less than a thousandth of its trust are none. Support in
 *  wall points. */
MeasuredValue wallsMissingOf(const SightingTable& sightings, const DistinctMaps& maps,
                             const Trust& trust, std::size_t run);

/** Of one run: `walls_added`, of its walls of which two others have seen the place, the share where
 *  all of these show free space: not of the whole map, in which a room that is drawn wrong is
 *  little, but of the kFewestWalls next to each other that have most of them. Others as for
 *  `walls_missing`. Support in wall points. O(patches^2). */
MeasuredValue wallsAddedOf(const SightingTable& sightings, const DistinctMaps& maps,
                           const Trust& trust, std::size_t run);

/** The same of those that are straight: `straight_walls_added`. */
MeasuredValue straightWallsAddedOf(const SightingTable& sightings, const DistinctMaps& maps,
                                   const Trust& trust, std::size_t run);

}  // namespace roomgraph
