#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// Ours
// In:   a file of places
// Out:  MarkedFile
// Next: carryThings

/** Reads what somebody has marked on a map. The content tells the format: a table, GeoJSON, a
 *  site.json, osmAG, or a mask of nav2.
 *  @throws DataError with one line where it is none, or damaged. */
MarkedFile readMarked(const std::string& file);

}  // namespace roomgraph
