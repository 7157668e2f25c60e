#pragma once
#include <vector>

#include "roomgraph/consensus/map_errors.h"
#include "roomgraph/consensus/mend_steps.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** Where the key frames of a run would lie if it agreed with itself. */
struct SelfConsensus {
  std::vector<Transform2D> poses;  ///< run <- robot, laid over the run as it was drawn
  MapError error;                  ///< of the run as it was drawn
  std::vector<PoseEdge> revisits;  ///< what was seen again, of all groups
};

/** Whether a revisit lies where the key frames are at `poses`. */
bool isBorneOut(const PoseEdge& revisit, const std::vector<Transform2D>& poses);

/** Looks for revisits and solves the pose graph of mended steps and revisits, and once more with
 *  the revisits that are found from there. */
SelfConsensus selfConsensus(const Run& run, const std::vector<LocalScan>& scans,
                            const MendedSteps& mended);

}  // namespace roomgraph
