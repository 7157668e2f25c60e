#pragma once
#include <string>
#include <vector>

#include "roomgraph/ledger/SiteFile.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

// In:   the rooms of a comparison, and what is known from earlier ones
// Out:  the same with the ids and names that they had, and the file brought up to date
// Next: comparisonJson, siteJson

/** Rooms with ids and names that stay, and the file that keeps them. */
struct NamedRooms {
  std::vector<SiteRoom> rooms;  ///< by their ids
  SiteFile file;
};

/** Gives each room that the file knows its id and name, and each other a new id, which it adds to
 *  the file. What the file knows and the comparison does not have stays. Of a known room the file
 *  keeps the shape as long as half of it is the same, so that small errors do not add up. The way
 *  from the one frame to the other: none, if most rooms lie where they lay; else alignMaps of maps
 *  drawn from the rooms. Rooms are then matched as the areas of a run are: matchAreas.
 *  `name` of the file, for messages. Without rooms nothing changes. O(rooms), or 0.2 s where frames
 *  differ.
 *  @throws DataError where the site cannot be found in the file, or in several ways, as in a
 *  symmetric building. */
NamedRooms nameRooms(std::vector<SiteRoom> rooms, SiteFile file, const std::string& name);

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
