#pragma once
#include <string>
#include <vector>

#include "ArchiveArguments.h"

namespace roomgraph {

/** Mends the copy of a run that an archive has kept, by the runs of `record`, or alone where there
 *  are none, and writes the mended one beside it, X.repaired.simplemap as X was compressed. What
 *  became of it, in one line. @throws DataError where the run cannot be read or written. */
std::string keepRepaired(const std::string& kept, const std::vector<std::string>& record,
                         const ArchiveArguments& arguments);

}  // namespace roomgraph
