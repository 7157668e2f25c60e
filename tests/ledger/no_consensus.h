#pragma once
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph::test {

/** Of runs without scans there is none. */
inline Consensus noConsensus(const Site& site) {
  Consensus consensus;
  consensus.graphRuns.resize(site.runs.size());
  return consensus;
}

}  // namespace roomgraph::test
