#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/relate/PreparedRun.h"
#include "roomgraph/relate/relate_maps.h"

namespace roomgraph {

// Ours
// In:   the runs
// Out:  MapPair of each pair of runs
// Next: compareRuns

/** Both indices of each pair of runs, a < b. */
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/** All pairs of `runs` runs, by a and then b. */
Pairs pairsOf(std::size_t runs);

/** The place of the pair a < b in pairsOf(runs). */
std::size_t pairIndex(std::size_t a, std::size_t b, std::size_t runs);

/** The run through which all others are related: of those that have seen at least half as much as
 *  the largest, the one with the straightest walls; of equal ones the first. 0 for no runs. */
std::size_t hubOf(const std::vector<PreparedRun>& runs);

/** Where pairs are kept from call to call, as pairBytes under a name that stands for both maps and
 *  the hub. Called from any thread; must not throw. What cannot be read is worked out again. */
struct KeptPairs {
  std::function<std::optional<std::string>(const std::string& name)> read;
  std::function<void(const std::string& name, const std::string& bytes)> write;
};

/** What relateMaps gives for each pair of pairsOf(runs.size()), in that order: first those with the
 *  hub, then the others by relateMapsOver, which saves nearly all of the search. With `areAligned`
 *  by relateAlignedMaps. Pairs that are kept are not worked out again, so that one more run costs
 *  its own pairs only, unless it becomes the hub. The same for any order of the jobs, and with or
 *  without kept pairs. */
std::vector<MapPair> relateRuns(const std::vector<PreparedRun>& runs, bool areAligned,
                                const ForEach& forEach, const KeptPairs& kept = {});

}  // namespace roomgraph
