#pragma once
#include <string>

#include "object_bytes.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/mrpt_plugin/MappedComparison.h"

namespace roomgraph {

constexpr ObjectKind kMapComparisonObject{"CMapComparison", "comparison of maps",
                                          "give a comparison.roomgraph", 0};

/** Everything that a MappedComparison holds: the comparison as JSON, then the walls of each run. */
std::string comparisonBytes(const MappedComparison& comparison);

/** Reads comparisonBytes() back. Throws DataError with one line, beginning with `name`, unless each
 *  count fits the bytes, each coordinate is finite and no byte is left over. */
void readComparisonBytes(ByteView bytes, const std::string& name, MappedComparison& comparison);

}  // namespace roomgraph
