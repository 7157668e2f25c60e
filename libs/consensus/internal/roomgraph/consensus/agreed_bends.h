#pragma once
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   what each two runs have in common, and what all of them agree on
// Out:  how far each two runs bend apart, so that it fits their map errors
// Next: measureSite

/** The bends of the runs of a site, which stand in for those that the walls alone have told where
 *  all runs have scans: what a run has drawn of what was found in another one, against where that
 *  one would have drawn it. As in siteErrors, a run without scans leaves all as it was, as does a
 *  pair of which the consensus takes nothing for right. O(edges). */
PairBends agreedBends(const Site& site, const Consensus& consensus, PairBends bends);

}  // namespace roomgraph
