#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// RFC 7946, osmAG (see osmXml), nav2_map_server
// In:   the text of a marked file
// Out:  MarkedFile
// Next: carryThings

// Each throws DataError in the name of `file` where the text is no such file; looksLike...(): it
// may be one. Carried, things get `state`, `error_m` and, where they are not carried, `reason`, and
// JSON without any gets a `state` itself.

/** The places of a table with the columns x, y and, where there are, name and yaw [m, rad], in any
 *  order and beside others. A place without a name is called after its line. What they get is three
 *  columns more, unless there are such. Other cells stay byte for byte; x, y and yaw are empty
 *  where nothing is known. Each cell of x, y and yaw is to be a number. */
MarkedFile csvPlaces(const std::string& text, const std::string& file);

/** GeoJSON, in metres of the map: features of any geometry, in a collection or bare; their corners
 *  are carried. All other members stay, in their order. Of a route graph of nav2, edges (`startid`,
 *  `endid`) begin and end at their nodes. */
MarkedFile geojsonPlaces(const std::string& text, const std::string& file);
bool looksLikeGeojson(const std::string& text);

/** The rooms of a site, with their outlines and doors. All other members stay. */
MarkedFile sitePlaces(const std::string& text, const std::string& file);
bool looksLikeSite(const std::string& text);

/** The ways of a file of osmAG, and its nodes that have tags or are in no way, in the frame of its
 *  root, a node tagged name=root, which stays. What they get are tags; all other bytes but those of
 *  the nodes' elements stay. */
MarkedFile osmPlaces(const std::string& text, const std::string& file);
bool looksLikeXml(const std::string& text);

/** The marked regions of a keepout or speed mask, by its yaml: connected cells that are neither
 *  free nor unknown. Carried, each cell is bent as the maps are, and none gets lost: where two
 *  meet, what is marked more stays. Mode, thresholds, resolution and all other keys are kept; the
 *  picture is as large as the new map, or larger where something lies beside it. The key `regions`
 *  of the yaml, which nav2 skips, tells of each where it lies, how large it is, its state, error_m
 *  and reason. Pictures other than pgm are written as png. The picture must be readable. */
MarkedFile maskPlaces(const std::string& text, const std::string& file);
bool looksLikeMask(const std::string& text);

}  // namespace roomgraph
