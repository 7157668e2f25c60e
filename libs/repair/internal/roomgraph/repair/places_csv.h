#pragma once
#include <string>
#include <vector>

#include "roomgraph/repair/CarriedPlace.h"

namespace roomgraph {

// Ours
// In:   a table of places
// Out:  Places, and the same table with them carried
// Next: carryPlaces, StagedFiles

/** The places of a table with the columns x, y and, where there are, name and yaw [m, rad], in any
 *  order and beside others. A place without a name is called after its line. `file` is named in
 *  errors.
 *  @throws DataError for a table without these columns, or with a cell that is no number. */
std::vector<Place> placesOfCsv(const std::string& text, const std::string& file);

/** The same table with the places where they were carried, one of `carried` for each, and three
 *  columns more: state, error_m and reason. Other columns stay as they were; x, y and yaw are empty
 *  where nothing is known. */
std::string carriedCsv(const std::string& text, const std::string& file,
                       const std::vector<CarriedPlace>& carried);

}  // namespace roomgraph
