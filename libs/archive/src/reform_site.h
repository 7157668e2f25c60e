#pragma once
#include <cstdint>
#include <string>

#include "Database.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/ledger/SiteFile.h"

namespace roomgraph {

// In:   an archive, and Comparison
// Out:  the site anew, where more runs agree with each other than it has
// Next: Archive::record

/** Where more runs agree with each other than a site has, they are the site: a wrong first map
 *  locks nobody out. The runs that were placed before become runs of another site and lose their
 *  figures, those of the comparison that are known are placed, and the rooms begin anew. Changes
 *  nothing where a placed run is among the compared ones, or where the comparison has fewer than
 *  three. To be called within a transaction. O(runs of the site). */
void reformSite(Database& database, std::int64_t site, const Comparison& comparison);

/** Whether a run of the comparison is placed in the site. O(runs of the comparison). */
bool hasPlaced(Database& database, std::int64_t site, const Comparison& comparison);

/** Whether the rooms that a site knows have been seen by fewer runs than agree in a comparison, of
 *  which there must be three: rooms of a bad first night. O(sightings of the site). */
bool areRoomsOutvoted(Database& database, std::int64_t site, const Comparison& comparison);

/** Gives the rooms of a comparison the ids and names of the site, see nameRooms. A room that the
 *  site does not know yet is remembered only where two runs have it, or too few were compared to
 *  ask that; else it is dropped from the comparison: one torn map is not to leave its rooms behind
 *  for ever. `name` is that of the archive. @throws DataError like nameRooms; nothing is changed
 *  then. */
void nameKnownRooms(Comparison& comparison, SiteFile& ledger, const std::string& name);

}  // namespace roomgraph
