#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** Measures of a map by itself, from how sharp its walls are: less is better. In the plane, where
 *  the literature has points in space. */
struct MapMetrics {
  /** Mean map entropy, Razlaw et al. 2015: mean of ln |2 pi e C| / 2 over the points, C being the
   *  covariance of what lies round a point. */
  double entropy = 0;
  /** Mean plane variance, ibid.: mean of the smaller eigenvalue of C [m2]. */
  double variance = 0;
  /** Mutually orthogonal metric, Kornilova and Ferrer 2022: the same over straight walls along the
   *  two main directions only, the median of each direction, summed [m2]. */
  double orthogonal = 0;
};

struct MapMetricsOptions {
  double radius = 0.5;          ///< of what lies round a point [m]
  std::size_t minPoints = 6;    ///< there, or the point does not count
  std::size_t samples = 10000;  ///< of the points, evenly, whose surroundings are looked at
  double maxWidth = 0.05;       ///< of a straight wall: smaller over larger eigenvalue
  double maxDeviation = 0.09;   ///< of a wall from a main direction [rad]
};

/** Of the points of all scans in the frame of the map. */
MapMetrics mapMetrics(const std::vector<Point>& points, const MapMetricsOptions& options);

}  // namespace roomgraph
