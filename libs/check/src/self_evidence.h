#pragma once
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/check/beams_through_walls.h"
#include "roomgraph/consensus/mend_steps.h"
#include "roomgraph/relate/Run.h"
#include "self_consensus.h"

namespace roomgraph {

// In:   a run, its mended steps, and its self-consensus
// Out:  the table of evidence
// Next: RunCheck

/** What a run tells against itself, a row each: by its scans and, last, by its map alone. Of a run
 *  without scans only the latter. O(revisits). */
std::vector<Evidence> selfEvidence(const Run& run, const MendedSteps& mended,
                                   const SelfConsensus& consensus, const BeamsThroughWalls& drawn,
                                   const BeamsThroughWalls& agreed);
std::vector<Evidence> mapEvidence(const Run& run);

}  // namespace roomgraph
