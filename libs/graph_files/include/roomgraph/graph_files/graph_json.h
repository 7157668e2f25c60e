#pragma once
#include <string>

#include "roomgraph/graph_files/GraphFile.h"

namespace roomgraph {

// In:   Stages, or a GraphFile
// Out:  the text of a JSON file
// Next: writeFileAtomically, readGraphJson

/** The text of a roomgraph/graph version 1 file; share/roomgraph/schema/graph-1.schema.json says
 *  what each field means. Ids are places in the lists; vertices, edges, rooms, areas and passages
 *  stand on a line each. Lengths and coordinates are rounded to 0.1 mm, and `area` is that of the
 *  rounded polygon. The same file gives the same bytes. Numbers that are not finite are written as
 *  null.
 *
 *      writeFileAtomically("office.json", graphJson(extract(loadGrid("office.yaml", {}), {})));
 *      const GraphFile again = readGraphJson("office.json");  // the same graph
 *
 *  O(size of the text). */
[[nodiscard]] std::string graphJson(const GraphFile& file);

/** The file of an extraction. */
[[nodiscard]] std::string graphJson(const Stages& stages);

}  // namespace roomgraph
