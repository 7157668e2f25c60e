#pragma once
#include <string>
#include <vector>

#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

// In:   AreaGraph
// Out:  the text of an OSM file
// Next: writeFileAtomically

struct OsmXmlOptions {
  double tolerance = 0;            ///< how far outlines may be from those of the areas [m]
  bool hasNumbers = false;         ///< areas are named by their ids, as osmAG's planner reads them
  std::vector<std::string> names;  ///< of the areas, each another; empty for room_3, corridor_7
};

/** The areas as OpenStreetMap XML in the manner of osmAG (Feng et al., "osmAG: Hierarchical
 *  Semantic Topometric Area Graph Maps in the OSM Format for Mobile Robotics", ROBIO 2023), for its
 *  planners and for JOSM.
 *
 *  - Nodes are the corners of the polygons, one for each place; corners on a straight line are left
 *    out, but for the ends of passages. The first node is the root, tagged name=root: the origin of
 *    the map frame, at latitude and longitude 0, as the map does not tell where on Earth it is. The
 *    others lie as far east (x) and north (y) of it as in the map, by the radii of WGS84 at the
 *    root (equirectangular), to 0.1 mm. Where areas are more than 100 km from that origin, the root
 *    is in their midst, with its place on the map in the tags roomgraph:x and roomgraph:y [m].
 *  - An area is a closed way, counter-clockwise, tagged osmAG:type=area, osmAG:areaType=room or
 *    corridor, indoor the same, and name=room_3 or corridor_7 by the area's id, or its name; level
 *    and height are 0, as the map does not tell on which floor it is. An area with holes is also
 *    the outer member of a relation type=multipolygon; its holes are ways without tags.
 *  - A passage is a way of two nodes, its ends, which are nodes of both areas; tagged
 *    osmAG:type=passage, osmAG:from and osmAG:to with the names of the areas (osmAG's semantic
 *    variant: JOSM changes ids when it saves; with hasNumbers their ids), level, name=passage_2 and
 *    width [m].
 *  - The floor is a closed way, the convex hull of all areas, tagged osmAG:areaType=structure, and
 *    the osmAG:parent of all areas.
 *
 *  Ids are negative, as those of all that is not in OSM's data base: nodes, ways and relations each
 *  count from -1 down, areas before passages, the floor, holes. Same areas, same bytes. O(n log n)
 *  in the number of corners. */
[[nodiscard]] std::string osmXml(const AreaGraph& graph, const OsmXmlOptions& options = {});

}  // namespace roomgraph
