#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/consensus/map_errors.h"
#include "roomgraph/consensus/mend_steps.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   the scans of a run, and MendedSteps
// Out:  SelfConsensus, and whether what was seen twice bears it out
// Next: repairAlone

/** Where the key frames of a run would lie if it agreed with itself. */
struct SelfConsensus {
  std::vector<Transform2D> poses;  ///< run <- robot, laid over the run as it was drawn
  MapError error;                  ///< of the run as it was drawn
  std::vector<PoseEdge> revisits;  ///< what was seen again, of all groups
};

/** Whether a revisit lies where the key frames are at `poses`. */
bool isInlier(const PoseEdge& revisit, const std::vector<Transform2D>& poses);

/** Looks for revisits and solves the pose graph of mended steps and revisits, and once more with
 *  the revisits that are found from there. */
SelfConsensus selfConsensus(const Run& run, const std::vector<LocalScan>& scans,
                            const MendedSteps& mended);

/** Whether a run may be laid as its self-consensus has it: of what was seen twice much more fits
 *  there than does not, and of each break (the place in `consensus.poses` of the first scan behind
 *  it) two scans on either side were seen from the other side and fit. Without that a break may be
 *  real, but how the parts lie to each other is what one scan says, and buildings repeat
 *  themselves. O(revisits * breaks). */
bool isConfirmed(const SelfConsensus& consensus, const std::vector<std::size_t>& breaks);

}  // namespace roomgraph
