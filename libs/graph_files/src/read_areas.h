#pragma once
#include "roomgraph/geometry/point_json.h"
#include "roomgraph/rooms/AreaGraph.h"

namespace roomgraph {

/** The areas and passages of a roomgraph/graph file, without labels; none where the file is of a
 *  program that did not know them yet. Throws Broken. */
AreaGraph readAreas(const JsonNode& top, std::size_t roomCount);

}  // namespace roomgraph
