#pragma once
#include <optional>
#include <string>
#include <vector>

#include "drift.h"
#include "sample_office.h"

namespace roomgraph {

/** One drive of a robot through the sample office, and what it believes of it. */
struct SampleRun {
  std::string name;
  std::vector<WalkPose> truth;         ///< in the frame of the office
  std::vector<Transform2D> believed;   ///< in the frame of the run
  std::optional<std::size_t> breakAt;  ///< the first pose behind the break
  double breakTurn = 0;                ///< [rad]
};

/** Four runs with their own ways, starts and frames: a good one, one that drifts, one that drifts
 *  badly, and one whose heading jumps once. */
std::vector<SampleRun> sampleRuns(const SampleOffice& office);

}  // namespace roomgraph
