#pragma once
#include "roomgraph/base/ForEach.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   a site, where its runs really lie, and their scores
// Out:  the scores, without those that the beams of a run refute
// Next: summarize

/** Asks of each run with scans whether it has laid two places over each other (findWelded) that the
 *  consensus has not parted either: it may fit the others well where a building repeats itself. If
 *  its error is reported as less than kBreakShift, and its beams still go through clearly more
 *  walls than those of any other run (glass and people are there for all), the two key frames are
 *  noted in its score, which is not meaningful then. Cost: that of two beamsThroughWalls a run. */
void askBeams(const Site& site, const Consensus& consensus, RunScores& scores,
              const ForEach& forEach);

}  // namespace roomgraph
