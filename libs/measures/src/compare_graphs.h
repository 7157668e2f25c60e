#pragma once
#include <array>
#include <optional>

#include "MeasuredValue.h"
#include "match_graphs.h"
#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

// After the attributes of Schwertfeger and Birk (2015); the formulas are ours
// In:   GraphMatch
// Out:  GraphComparison: how far two graphs agree
// Next: graphMeasureOf

/** How many hops apart the pairs of vertices are whose distances are compared. */
constexpr std::array<std::size_t, 4> kConsistencyHops{1, 2, 4, 8};

struct GraphComparison {
  /** Share of the other's path length that a, or b, has [of m]. */
  MeasuredValue coverageOfA, coverageOfB;
  MeasuredValue globalAccuracy;    ///< RMS distance of matched vertices in the common frame [m]
  MeasuredValue relativeAccuracy;  ///< the same after the turn and shift that fits them best [m]
  /** For each of kConsistencyHops, of all pairs of matched vertices so many matched paths apart:
   *  median of | |pi - pj| - |qi - qj| | / length of these paths, which is the mean of both. */
  std::array<MeasuredValue, kConsistencyHops.size()> consistency;
  MeasuredValue lengthError;  ///< median over the paths of |la - lb| / max(la, lb)
  MeasuredValue frechet;      ///< median over the paths outside of rooms of pathFrechet [m]
  /** nearestVertices from a to b, and from b to a [m, of vertices]. */
  MeasuredValue nearestA, nearestB;
};

/** `inSite`: poses that place a and b in one frame. A single matched vertex has no relative
 *  accuracy. Swapping the graphs swaps the answers but for exact ties.
 *  O(vertices * vertices + paths). */
GraphComparison compareGraphs(const TopologyGraph& a, const TopologyGraph& b,
                              const GraphMatch& match, const std::array<Transform2D, 2>& inSite);

/** The discrete Frechet distance of two lines [m], each cut evenly into the same number of steps
 *  (about 0.25 m, at most 64), after `b` has been moved so that its ends lie as near to those of
 *  `a` as a turn and a shift allow. Where the ends of one lie close together, as those of a loop,
 *  they give no direction: then all of `b` is laid on `a` as well as possible. 0 for equal lines;
 *  the same when both are swapped or walked backwards. None where a line has no length.
 *  O(points + steps^2). */
std::optional<double> pathFrechet(const Polyline& a, const Polyline& b);

}  // namespace roomgraph
