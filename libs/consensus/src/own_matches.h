#pragma once
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/consensus/match_nodes.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   a run with scans
// Out:  FoundGroup
// Next: findConsensus

/** What `of` gives of each run with scans but the reference, in the order of the runs. */
template <class Found, class Of>
std::vector<Found> gathered(const PoseGraph& graph, const ForEach& forEach, const Of& of) {
  std::vector<std::vector<Found>> found(graph.runs.size());
  forEach(found.size(), [&](std::size_t index) {
    const RunId run(index);
    if (graph.runs[run].hasScans && run != graph.reference) found[index] = of(run);
  });
  std::vector<Found> all;
  for (const std::vector<Found>& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

/** Which scans have next to nothing in common with the two before them, though they lie beside them
 *  as drawn. O(scans * walls^2). */
std::vector<bool> barelyHeldSteps(const Run& run);

/** The steps of a run to what no other run confirms (confirmedNodes), and from there on, and those
 *  beside them: where a run is torn near its end, others only fail to find what lies behind.
 *  O(nodes of the run). */
std::vector<bool> stepsToUnconfirmed(const IdRange<NodeId>& nodes,
                                     const ById<NodeId, bool>& isConfirmed);

/** What a run tells of its own breaks, whatever others have seen: the steps `asked` for are held
 *  against its scans by mendSteps. Where that contradicts the run at one step alone, the scans
 *  behind it are found in the scan before it, as the group of one stretch. The cost of mendSteps
 *  for those steps. */
std::vector<FoundGroup> ownMatches(const PoseGraph& graph, RunId id, const Run& run,
                                   const std::vector<bool>& asked);

/** The links that give way in the consensus though the scans on both sides of them agree with the
 *  step as it was drawn and refute the one that the consensus has: what was found of the run beyond
 *  them lies in a place that only looks like it. And those where the run may not be torn instead,
 *  as the walls there refute the same motion, up to the next links that give way. None of the
 *  reference and of runs without scans. O(scans^2) for each link that gives way. */
std::vector<PoseEdgeId> heldSteps(const Site& site, const Consensus& consensus,
                                  const ForEach& forEach);

/** How many runs a link of which has given way. O(links). */
std::size_t tornRuns(const Consensus& consensus);

}  // namespace roomgraph
