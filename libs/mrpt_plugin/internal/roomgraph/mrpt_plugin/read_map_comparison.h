#pragma once
#include <string>

#include "roomgraph/mrpt_plugin/MappedComparison.h"

namespace roomgraph {

/** What a comparison.roomgraph holds, see loadMapComparison(); it needs nothing of MRPT.
 *  @throws DataError with one line (file, problem, remedy). */
MappedComparison readMapComparison(const std::string& path);

}  // namespace roomgraph
