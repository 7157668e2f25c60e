#pragma once
#include <string>

#include "roomgraph/ledger/SiteFile.h"

namespace roomgraph {

// Ours
// In:   SiteFile, or its text
// Out:  its text, or SiteFile
// Next: a file, or nameRooms

/** Reads version 1. Fields that it does not know are skipped, and lost when the file is written
 *  anew. A room without a name is named by its id; doors to rooms that are not there lead nowhere.
 *  @throws DataError with one line (`name` of the file, place, problem, remedy) where it is no such
 *  file, or damaged. */
SiteFile parseSiteJson(const std::string& text, const std::string& name);

/** Its text: one room per line, so that names are easy to edit. Places are rounded to 0.1 mm. */
std::string siteJson(const SiteFile& file);

}  // namespace roomgraph
