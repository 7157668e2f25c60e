#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// osmAG, see osmXml
// In:   the text of an OSM file
// Out:  MarkedFile
// Next: carryThings

/** The ways of a file of osmAG, and its nodes that have tags or are in no way, in the frame of its
 *  root, a node tagged name=root, which stays. Carried, each has the tags `state`, `error_m` and,
 *  where it is not carried, `reason`; all other bytes but those of the nodes' elements stay.
 *  @throws DataError in the name of `file` where it is no such file. */
MarkedFile osmPlaces(const std::string& text, const std::string& file);

/** Whether a text may be one. */
bool looksLikeXml(const std::string& text);

}  // namespace roomgraph
