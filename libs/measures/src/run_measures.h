#pragma once
#include <array>
#include <vector>

#include "MeasuredValue.h"
#include "roomgraph/align/WallMap.h"
#include "roomgraph/base/PairTable.h"
#include "roomgraph/geometry/Point.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/relate/DistinctMaps.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

/** A frame round the walls of all placed runs, with the coarsest of their cells, 0.1 m or more;
 *  a single cell where there are no walls. O(walls). */
GridFrame siteFrame(const Site& site);

/** Whether a run has seen free space at `p` [m, frame of the map]. */
bool isFreeIn(const WallMap& map, Point p);

// In:   the runs of a site, placed
// Out:  MeasuredValue
// Next: measureSite

/** Per run: `coverage`, of all places that two runs have seen free the share that this one has seen
 *  free. Of runs with the same map one counts, and none that is hardly trusted beside the two
 *  best. Meaningful with three maps and 10 m2. Support in cells. O(runs * cells of the site). */
std::vector<MeasuredValue> coverageOf(const Site& site, const DistinctMaps& maps,
                                      const Trust& trust);

/** Of one run: `bend`, its mean bend against the others, weighted by trust [m]; copies of its map
 *  are no others, unless there are no more. Support in wall points. */
MeasuredValue bendOf(const PairBends& bends, const DistinctMaps& maps, const Trust& trust,
                     std::size_t run);

/** Of a pair: how far its maps bend [m], and the share of the walls that both have. Support in wall
 *  points. */
MeasuredValue bendOfPair(const PairBend& bend);
MeasuredValue followedOfPair(const PairBend& bend);

/** Of one run: `axis_deviation`, see axisDeviation [deg]. Support in wall points; no interval, as
 *  the others have no part in it. */
MeasuredValue axisDeviationOf(const Run& run);

/** How far the walls of one map lie from those of another. */
struct WallDistances {
  static constexpr double kStep = 0.005;  ///< of the histogram [m]
  double sum = 0;  ///< of the distances, each at most WallMap::kReach: also where there is none [m]
  double count = 0;  ///< wall points
  /** Points by distance, rounded to kStep. */
  std::array<double, std::size_t(WallMap::kReach / kStep) + 1> histogram{};

  /** none for no points: 0. */
  double mean() const { return count > 0 ? sum / count : 0; }
  /** Counts `other` in, `weight` times. */
  void add(const WallDistances& other, double weight = 1);
  /** The distance that a share of the points does not exceed, to half a kStep; 0 without points. */
  double quantile(double share) const;
};

/** For each wall point of `map` that lies where `other` has seen free space or wall: the distance
 *  to the nearest wall of `other` that faces about the same way (within 45 degrees, see
 *  nearestWall). `pose` is other <- map. A map against itself gives zeros. O(points). */
WallDistances wallDistances(const WallMap& map, const WallMap& other, const Transform2D& pose);

/** How far the walls of each run lie from those of the others. */
using DistanceTable = DirectedTable<WallDistances>;

/** Of one run: the quantile `share` of the distances of its walls to those of the others, weighted
 *  by trust [m]. Support in wall points. */
MeasuredValue wallDistanceOf(const DistanceTable& distances, const Trust& trust, std::size_t run,
                             double share);

/** Of a pair: a quantile of the distances of the walls of both, and their mean [m]. */
MeasuredValue wallDistanceOfPair(const DistanceTable& distances, std::size_t a, std::size_t b,
                                 double share);
MeasuredValue meanWallDistanceOfPair(const DistanceTable& distances, std::size_t a, std::size_t b);

}  // namespace roomgraph
