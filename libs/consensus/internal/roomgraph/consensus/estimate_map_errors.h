#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/consensus/map_errors.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {

// In:   how far each two maps bend apart, and how far each is from right angles
// Out:  MapError of each map
// Next: errorsByBends

/** Fitted to simulated runs whose true error is known, see docs/method.md;
 *  benchmarks/score_accuracy judges them. */
namespace fitted {

constexpr double kBendNoise = 0.02;        ///< of a bend that is 0 [m]
constexpr double kBendAbove = 1.0;         ///< log of bend over errors: beyond, less counts
constexpr double kBendBelow = 0.5;         ///< the same for bends that are too small
constexpr double kDeviationWeight = 0.3;   ///< of one map's axisDeviation beside one pair
constexpr double kDeviationWidth = 2;      ///< log of error over what it tells: beyond, less
constexpr double kDeviationPower = 1.6;    ///< of the deviation in the error
constexpr double kDeviationNoise = 0.003;  ///< of a deviation that is 0 [rad]
constexpr double kErrorNoise = 0.03;       ///< of an error that is 0, as the deviation tells it [m]
constexpr double kLeastError = 0.0025;     ///< errors below this are none [m]
constexpr double kErrorSpread = 0.25;      ///< standard deviation of a residual's log
constexpr double kLeastErrorSpread = 0.15;  ///< of an error's log, however many pairs there are

}  // namespace fitted

/** The errors that explain the bends and the deviations best. Two maps with errors e and f should
 *  bend sqrt(e^2 + f^2) apart, if each errs in its own way. A log residual counts as in a Cauchy
 *  distribution where a pair bends more than that, so that one outlier moves little, but as far as
 *  it goes where it bends less: maps that err by metres do not agree within decimetres by chance.
 *  The deviations tell errors up to a factor that is free, as it depends on the building, and count
 *  as in a Cauchy distribution, too, since a map that is torn square stays straight; one that tells
 *  less error than the bends counts by the square of the largest share of walls that its map has in
 *  common with another, as a small piece of a site is straight whatever it is worth. None for a map
 *  with no pair. With `truth`, that map has no error, its deviation does not count, and none is
 *  given for it. O(n^3) a step, at most 200 steps for each of two starts. */
std::vector<std::optional<MapError>> estimateMapErrors(
    const PairBends& bends, const std::vector<std::optional<double>>& deviations,
    std::optional<std::size_t> truth);

}  // namespace roomgraph
