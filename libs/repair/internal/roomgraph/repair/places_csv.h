#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// Ours
// In:   a table of places
// Out:  MarkedFile
// Next: carryThings

/** The places of a table with the columns x, y and, where there are, name and yaw [m, rad], in any
 *  order and beside others. A place without a name is called after its line. Carried it has three
 *  columns more, unless it has them already: state, error_m and reason. Other columns stay as they
 *  were; x, y and yaw are empty where nothing is known.
 *  @throws DataError in the name of `file` for a table without these columns, or with a cell that
 *  is no number. */
MarkedFile csvPlaces(const std::string& text, const std::string& file);

}  // namespace roomgraph
