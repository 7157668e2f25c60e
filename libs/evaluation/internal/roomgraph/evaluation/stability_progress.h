#pragma once
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/evaluation/stability.h"

namespace roomgraph {

// In:   the runs that are done
// Out:  the text of a file to go on from after an interruption

/** One entry per run, in the order of stabilityRuns(); none where it is not done. */
using RunsDone = std::vector<std::optional<RunMeasures>>;

/** Everything that the measures of a run depend on besides its noise: map, options of the
 *  extraction, seed, base noise, matching distance, program version. */
std::string stabilityKey(const GreyMap::Source& source, const ExtractOptions& extract,
                         const StabilityOptions& options);

/** All digits are kept: what is read again equals what was computed. `key` is stabilityKey(). */
std::string progressText(const std::string& key, const std::vector<StabilityRun>& runs,
                         const RunsDone& done);

/** The measures of those of `runs` that `text` holds. None at all where `text` is of another key,
 *  or damaged. The runs need not be those that were planned when it was written. */
RunsDone readProgress(const std::string& text, const std::string& key,
                      const std::vector<StabilityRun>& runs);

}  // namespace roomgraph
