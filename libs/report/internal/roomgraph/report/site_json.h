#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"
#include "roomgraph/ledger/SiteFile.h"

namespace roomgraph {

// In:   SiteFile, or its text; the rooms of a Comparison
// Out:  its text, or SiteFile; the text of a GeoJSON file
// Next: a file, or nameRooms

/** Reads version 1. Fields that it does not know are skipped, and lost when the file is written
 *  anew. A room without a name is named by its id; doors to rooms that are not there lead nowhere.
 *  @throws DataError with one line (`name` of the file, place, problem, remedy) where it is no such
 *  file, or damaged. */
SiteFile parseSiteJson(const std::string& text, const std::string& name);

/** Its text: one room per line, so that names are easy to edit. Places are rounded to 0.1 mm. */
std::string siteJson(const SiteFile& file);

/** The rooms of a site over all runs, for QGIS and programs, in metres of the site's frame. Rooms
 *  and corridors are Polygons with id, name, kind, area_m2 and, by run, seen_in, gone_in and
 *  unvisited_in (names, best run first); doors are Points with room, to (null where it leads to no
 *  room of the site) and width. A door between two rooms is there once for each of them. By room.
 *  Same rooms, same bytes. */
std::string siteGeojson(const Comparison& comparison);

}  // namespace roomgraph
