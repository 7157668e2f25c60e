#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"
#include "self_consensus.h"

namespace roomgraph {

// Ours
// In:   SelfConsensus and the breaks that follow from it
// Out:  DoubledPlace
// Next: RunCheck

/** What lies so far from where it should has been drawn wrong, a step or a place [m]. */
constexpr double kTellsShift = 0.38;

/** The places that the run has drawn at two times kTellsShift or more apart, the farthest apart
 *  first: those that were seen again there, which its self-consensus bears out, and which lie apart
 *  also if the steps before the scans `broken` are put right. What was seen again along both
 *  stretches is one place. O(revisits^2). */
std::vector<DoubledPlace> findDoubled(const Run& run, const SelfConsensus& consensus,
                                      const std::vector<std::size_t>& broken);

}  // namespace roomgraph
