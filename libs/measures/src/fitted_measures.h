#pragma once
#include <cstddef>

/** What the measures were set by: `benchmarks/score_accuracy --data DIR` and
 *  `benchmarks/map_baselines --data DIR` show how each agrees with true errors. */
namespace roomgraph::fitted {

// Matching of vertices: what speaks against a pair, in metres of distance.
constexpr double kOtherKind = 0.3, kPerMetre = 0.5;
constexpr double kMaxSeed = 1;       // of vertices matched by their place; unlike ones cost it [m]
constexpr double kMaxGrown = 1.5;    // of neighbours of matched vertices [m]
constexpr double kAlikeWidth = 0.3;  // by which clearances of vertices differ that look alike [m]

// By how much the lengths of one way may differ: always this, and this share of the longer one.
constexpr double kLengthSlack = 0.5, kLengthShare = 0.25;  // [m]
constexpr double kMaxPathLength = 20;  // of a way through vertices that are not matched [m]

// Distance of two paths.
constexpr double kPathStep = 0.25;  // [m]
constexpr double kLoop = 0.3;       // share of the length below which the ends give no direction

// Scans of one place at two times.
constexpr double kSameView = 2;        // between the places of two scans that see the same [m]
constexpr std::size_t kMaxVisits = 8;  // scans that one is compared with, nearest first

// A run that is trusted less than this share of the second best, or of the one that is measured, is
// so torn or bent that it tells of places and free space that are not there.
constexpr double kLeastTrust = 1e-3;

}  // namespace roomgraph::fitted
