#pragma once
#include <cmath>
#include <cstddef>

/** What the alignment was fitted to: the pairs that benchmarks/alignment_accuracy writes with
 *  --features. Where no command is named, that benchmark judges. */
namespace roomgraph::fitted {

// By logistic regression: benchmarks/fit_confidence. An intercept first, then the weights.

/** Of what sameSiteLogOdds looks at, in its order. */
constexpr double kSameSite[] = {-4.307, 0.255, -0.787, -0.252, -0.212, 2.057,
                                0.303,  0.599, 0.791,  -5.394, -4.561};

/** Of what poseConfidence looks at, in its order. */
constexpr double kRightPose[] = {-0.956, 0.575, 1.432, 0.242, -1.111};

/** Probability from which on two maps are of the same site. */
constexpr double kMinSameSite = 0.61;

/** Of what alignmentScore looks at, in its order: by random search, for the most pairs in which the
 *  right pose wins over all others. */
constexpr double kScore[] = {0.7, 0.26, 0.17, 0.2, -2.0, -0.45, -0.37};

/** Below this margin of the score, a runner-up of such log odds makes a pose ambiguous: of 48 such
 *  answers, 30 were right. */
constexpr double kAmbiguousOdds = 2, kAmbiguousMargin = 2.5, kAmbiguousConfidence = 0.6;

/** With a runner-up that could be the same site by itself, even if worse, no answer is more than
 *  kSureConfidence: of 18 such answers for simulated grids, all were right. */
constexpr double kRivalMargin = 4;

/** Metres of wall that hold a sure pose in its weakest direction, else it may slide: of the four
 *  sure answers held by less than 3 m two were right; all others were held by 8 m or more. */
constexpr double kHeld = 5;

// What walls tell of a map by themselves: `benchmarks/map_baselines --data DIR` shows how it agrees
// with true errors.
constexpr double kFarthestCopy = 0.8;        // from one copy of a wall to the other [m]
constexpr double kDirectionReach = 1.5;      // of the walls that give a direction [m]
constexpr double kThickness = 0.25;          // of a wall, with its roughness [m]
constexpr double kMaxRoughness = 0.022;      // variance across over variance along
constexpr std::size_t kMinDirections = 100;  // walls that tell of right angles
constexpr double kAlike = M_PI / 60;  // directions that differ by less are those of parallel walls
constexpr double kLeastShare = 0.15;  // of the walls that have a direction in common

}  // namespace roomgraph::fitted
