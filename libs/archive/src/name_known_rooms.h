#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/ledger/SiteFile.h"

namespace roomgraph {

/** Gives the rooms of a comparison the ids and names of the site, see nameRooms. A room that the
 *  site does not know yet is remembered only where two runs have it, or too few were compared to
 *  ask that; else it is dropped from the comparison: one torn map is not to leave its rooms behind
 *  for ever. `name` is that of the archive. @throws DataError like nameRooms; nothing is changed
 *  then. */
void nameKnownRooms(Comparison& comparison, SiteFile& ledger, const std::string& name);

}  // namespace roomgraph
