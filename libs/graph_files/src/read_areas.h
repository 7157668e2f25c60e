#pragma once
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/geometry/point_json.h"

namespace roomgraph {

/** The areas and passages of a roomgraph/graph file, without labels; none where the file is of a
 *  program that did not know them yet. Throws Broken. */
AreaGraph readAreas(const JsonNode& top, std::size_t roomCount);

}  // namespace roomgraph
