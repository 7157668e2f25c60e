#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

// In:   a site, and where its runs really lie
// Out:  WeldedKeyFrames
// Next: scoreRuns, repairRuns

/** Two key frames of a run that lie over each other and are not one place; none where nothing is
 *  wrong. */
using WeldedKeyFrames = std::optional<std::pair<std::size_t, std::size_t>>;

/** Of each run of a site: what it has laid over each other (findWelded) and the consensus has not
 *  parted either. It may fit the others well where a building repeats itself. Only of runs whose
 *  error would be less than kBreakShift, or than kApartShift where the interval reaches that, and
 *  whose beams still go through clearly more walls than those of any other run (glass and people
 *  are there for all): how far these are off does not show. None of a reference, or without other
 *  runs. Cost: that of two beamsThroughWalls a run. */
std::vector<WeldedKeyFrames> findRefuted(const Site& site, const Consensus& consensus,
                                         const ForEach& forEach);

/** "has drawn key frames ..." */
std::string weldedText(const std::pair<std::size_t, std::size_t>& keyFrames);

}  // namespace roomgraph
