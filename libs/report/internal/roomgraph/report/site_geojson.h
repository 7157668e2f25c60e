#pragma once
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// Ours
// In:   Comparison
// Out:  the text of a GeoJSON file
// Next: a file

/** The rooms of a site over all runs, for QGIS and programs, in metres of the site's frame. Rooms
 *  and corridors are Polygons with id, name, kind, area_m2 and, by run, seen_in, gone_in and
 *  unvisited_in (names, best run first); doors are Points with room, to (null where it leads to no
 *  room of the site) and width. A door between two rooms is there once for each of them. By room.
 *  Same rooms, same bytes. */
std::string siteGeojson(const Comparison& comparison);

}  // namespace roomgraph
