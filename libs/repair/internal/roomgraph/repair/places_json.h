#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// RFC 7946, in metres of the map
// In:   GeoJSON
// Out:  MarkedFile
// Next: carryThings

/** Features of any geometry, in a collection or bare; their corners are carried, in the properties
 *  are `state`, `error_m` and, where it is not carried, `reason`. All other members stay, in their
 *  order. Of a route graph of nav2, edges (`startid`, `endid`) begin and end at their nodes.
 *  @throws DataError in the name of `file` where it is no GeoJSON. */
MarkedFile geojsonPlaces(const std::string& text, const std::string& file);

/** Whether a text may be GeoJSON. */
bool looksLikeGeojson(const std::string& text);

/** The rooms of a site, with their outlines and doors; each gets `state`, `error_m` and, where it
 *  is not carried, `reason`. All other members stay.
 *  @throws DataError in the name of `file` where it is no such file. */
MarkedFile sitePlaces(const std::string& text, const std::string& file);

/** Whether a text may be one. */
bool looksLikeSite(const std::string& text);

}  // namespace roomgraph
