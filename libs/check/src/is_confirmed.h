#pragma once
#include <cstddef>
#include <vector>

#include "self_consensus.h"

namespace roomgraph {

// Ours
// In:   SelfConsensus and the breaks that follow from it
// Out:  whether what was seen twice bears it out
// Next: repairAlone

constexpr std::size_t kLeastAcross = 2;  ///< revisits that bear out how two times lie to each other
constexpr std::size_t kFitsPerMiss = 2;  ///< revisits that fit for each that does not

/** Whether a run may be laid as its self-consensus has it: of what was seen twice much more fits
 *  there than does not, and each break (the place in `consensus.poses` of the first scan behind it)
 *  lies between two places that were seen again and fit. Without that a break may be real, but how
 *  the parts lie to each other is what one scan says, and buildings repeat themselves.
 *  O(revisits * breaks). */
bool isConfirmed(const SelfConsensus& consensus, const std::vector<std::size_t>& breaks);

}  // namespace roomgraph
