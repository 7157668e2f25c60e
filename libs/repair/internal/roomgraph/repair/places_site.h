#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// Ours
// In:   a file of format roomgraph/site
// Out:  MarkedFile
// Next: carryThings

/** The rooms of a site, with their outlines and doors; each gets `state`, `error_m` and, where it
 *  is not carried, `reason`. All other members stay.
 *  @throws DataError in the name of `file` where it is no such file. */
MarkedFile sitePlaces(const std::string& text, const std::string& file);

/** Whether a text may be one. */
bool looksLikeSite(const std::string& text);

}  // namespace roomgraph
