#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "roomgraph/base/sequences.h"
#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {

/** What all runs of a site agree on. The graph has the runs that count, of copies of one map only
 *  one; those of the core come first. */
struct Consensus {
  PoseGraph graph;
  GraphTrust trust;  ///< with which the poses were solved
  NodePoses poses;   ///< where the nodes really lie, in a frame of its own
  ById<RunId, MapError> errors;
  ById<RunId, std::size_t> siteRuns;  ///< the place of each run of the graph in the site
  std::vector<RunId> graphRuns;       ///< of each run of the site that which counts for it, or none

  /** The nodes of a run of the site, or of the one that counts for it. */
  IdRange<NodeId> nodesOf(std::size_t siteRun) const {
    const RunId run = graphRuns[siteRun];
    return run ? graph.runs[run].nodes : IdRange<NodeId>();
  }
  /** Where its scans really lie, or its patches: site <- node. */
  std::vector<Transform2D> posesOf(std::size_t siteRun) const {
    return mapped(nodesOf(siteRun), [&](NodeId node) { return poses[node]; });
  }
  MapError errorOf(std::size_t siteRun) const {
    const RunId run = graphRuns[siteRun];
    return run ? errors[run] : MapError();
  }
  /** Whether a run of the site counts itself. */
  bool isCounted(std::size_t siteRun) const {
    const RunId run = graphRuns[siteRun];
    return run && siteRuns[run] == siteRun;
  }
};

/** The pose graph as g2o has it, which GTSAM and others read, too: a VERTEX_SE2 for each node,
 *  where it really lies, and an EDGE_SE2 for each link and match, with the information that it had
 *  in the last step of the solution: what contradicts the rest has next to none. So plain least
 *  squares go on from there. The first node is fixed. Same consensus, same bytes. O(nodes + edges).
 */
std::string graphG2o(const Consensus& consensus);

}  // namespace roomgraph
