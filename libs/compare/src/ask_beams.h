#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/compare/run_score.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// Ours
// In:   a site, where its runs really lie, and their scores
// Out:  WeldedKeyFrames, and no scores of such runs
// Next: summarize

/** Two key frames of a run that lie over each other and are not one place; none where nothing is
 *  wrong. */
using WeldedKeyFrames = std::optional<std::pair<std::size_t, std::size_t>>;

/** Asks of each run with scans whether it has laid two places over each other (findWelded) that the
 *  consensus has not parted either: it may fit the others well where a building repeats itself. If
 *  its error is reported as less than kBreakShift, and its beams still go through clearly more
 *  walls than those of any other run (glass and people are there for all), it loses its score: how
 *  far it is off does not show. Cost: that of two beamsThroughWalls a run. */
std::vector<WeldedKeyFrames> askBeams(const Site& site, const Consensus& consensus,
                                      RunScores& scores, const ForEach& forEach);

}  // namespace roomgraph
