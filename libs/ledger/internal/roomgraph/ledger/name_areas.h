#pragma once
#include <string>
#include <vector>

#include "roomgraph/ledger/SiteFile.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

// Ours
// In:   the areas of one map, and what is known of its site
// Out:  the names of the areas, and the file brought up to date
// Next: osmXml, geojson, graphJson, siteJson

struct NamedAreas {
  std::vector<std::string> names;  ///< by AreaId, no two the same
  SiteFile file;
};

/** Gives each area the name of its room in the file, or that of a new one, see nameRooms. Where
 *  users have given one name to several rooms, their ids tell them apart: "Office (R3)". `name` of
 *  the file, for messages.
 *  @throws DataError like nameRooms. */
NamedAreas nameAreas(const AreaGraph& areas, SiteFile file, const std::string& name);

}  // namespace roomgraph
