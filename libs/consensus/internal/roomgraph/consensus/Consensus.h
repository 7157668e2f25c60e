#pragma once
#include <cstddef>
#include <vector>

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

}  // namespace roomgraph
