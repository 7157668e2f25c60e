#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"
#include "self_consensus.h"

namespace roomgraph {

// In:   SelfConsensus and the breaks that follow from it
// Out:  DoubledPlace
// Next: RunCheck

/** The places that the run has drawn at two times kBreakShift or more apart, the farthest apart
 *  first: those that were seen again there, which its self-consensus bears out, and which lie apart
 *  also if the steps before the scans `broken` are put right. What was seen again along both
 *  stretches is one place. O(revisits^2). */
std::vector<DoubledPlace> findDoubled(const Run& run, const SelfConsensus& consensus,
                                      const std::vector<std::size_t>& broken);

}  // namespace roomgraph
