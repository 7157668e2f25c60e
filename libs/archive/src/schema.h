#pragma once
#include "Database.h"

namespace roomgraph {

/** Makes an archive of an empty file; several programs may do so at once.
 *  @throws DataError where the file is one of another program, or of a later version. */
void migrate(Database& database);

}  // namespace roomgraph
