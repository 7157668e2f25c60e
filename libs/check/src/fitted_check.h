#pragma once
#include <cstddef>

#include "roomgraph/align/near_poses.h"

/** What tells that a run contradicts itself: set on the runs that `benchmarks/score_accuracy --data
 *  DIR` compares, whose true errors are known; see "One run by itself" in benchmarks/README.md. */
namespace roomgraph::fitted {

// What a run has passed at two times.
constexpr std::size_t kMostScans = 12;        // of a pass
constexpr std::size_t kMaps = 2;              // in which a scan is looked for
constexpr PoseTolerance kDrift{0.003, 0.02};  // per metre of path
constexpr PoseTolerance kMostWindow{0.5, 3};
constexpr double kLeastScore = 8, kLeastHold = 0.08;  // of a scan that is found again

// What is seen twice of a run, so that it can be told of.
constexpr std::size_t kSeenBeside = 2;   // scans to either side that count as seen
constexpr double kLeastSeenTwice = 0.1;  // share of the path, to tell of a run without a break
constexpr std::size_t kLeastAcross = 2;  // scans that bear out how two times lie to each other
constexpr std::size_t kFitsPerMiss = 2;  // revisits that fit for each that does not

// Share of the steps that break; where more do, it is the scanner that is wrong. Of 171 real and
// simulated runs at most 0.10; of runs with a lidar turned by 8 degrees, or late, 0.20 and 0.36.
constexpr double kMostBroken = 0.125;

// Beams through walls.
constexpr double kMoreBeams = 1.4;      // times as many: by few they may differ
constexpr std::size_t kLeastPairs = 6;  // one or the other may have seen people, or through glass

}  // namespace roomgraph::fitted
