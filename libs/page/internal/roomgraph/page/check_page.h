#pragma once
#include <string>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   RunCheck, and the run that it is of
// Out:  text of a page for a browser
// Next: a file

/** A page that stands alone: what the run tells of itself, its map with the path coloured by what
 *  is known of it, and each break, the largest first, with the scans before it and after laid
 *  over each other as they were drawn and as they fit. */
std::string checkPage(const RunCheck& check, const Run& run);

}  // namespace roomgraph
