#pragma once
#include <cstddef>

#include "roomgraph/align/near_poses.h"

/** What tells that a run breaks, and where; from which size on it is one, MapBreak.h says.
 *  `benchmarks/break_accuracy --data DIR` holds what is found against where simulated runs
 *  break. */
namespace roomgraph::fitted {

// Runs with scans: steps of their track through another map.
constexpr std::size_t kMinSteps = 20;  // of a track, to know what is usual
constexpr double kOutlier = 4;         // times the 95th percentile of the run's other steps
// In so many steps a break may come about; as many on either side bear it out, and are quiet around
// a sharp one.
constexpr std::size_t kFewSteps = 3;

// Runs without scans: pieces of patches.
constexpr std::size_t kWitnesses = 3;        // runs in which the patches of another are looked at
constexpr double kPieceReach = 4.5;          // between patches that may hold each other [m]
constexpr double kLeastPiece = 0.08;         // of the walls found, of a piece that counts
constexpr PoseTolerance kOfPiece{0.2, 2.4};  // a patch beside its piece; half of both, or one
constexpr double kMostHeld = 0.02;           // share of near patches of two pieces that may hold

}  // namespace roomgraph::fitted
