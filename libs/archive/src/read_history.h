#pragma once
#include <string>

#include "Database.h"
#include "roomgraph/archive/SiteHistory.h"

namespace roomgraph {

/** "seen", "gone" or "unvisited", as in the tables. */
const char* sightingText(RoomSighting sighting);

/** All that the tables have of a site; empty for one that is not there. */
SiteHistory readHistory(Database& database, const std::string& site);

}  // namespace roomgraph
