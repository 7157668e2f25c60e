#pragma once
#include <string>

#include "roomgraph/consensus/Consensus.h"

namespace roomgraph {

// Ours
// In:   Consensus
// Out:  the text of a g2o file
// Next: StagedFiles

/** The pose graph as g2o has it, which GTSAM and others read, too: a VERTEX_SE2 for each node,
 *  where it really lies, and an EDGE_SE2 for each link and match, with the information that it had
 *  in the last step of the solution: what contradicts the rest has next to none. So plain least
 *  squares go on from there. The first node is fixed. Same consensus, same bytes. O(nodes + edges).
 */
std::string graphG2o(const Consensus& consensus);

}  // namespace roomgraph
