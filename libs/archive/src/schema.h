#pragma once
#include <string>
#include <vector>

#include "Database.h"

namespace roomgraph {

/** What brings the tables of an archive from each version to the next, the first from an empty
 *  file. A step that was ever released stays as it is. */
const std::vector<std::string>& schemaSteps();

/** Brings an archive to the latest version, each step in a transaction of its own, so that several
 *  programs may do so at once. An empty file becomes an archive.
 *  @throws DataError where the file is one of another program, or of a later version. */
void migrate(Database& database, const std::vector<std::string>& steps);

}  // namespace roomgraph
