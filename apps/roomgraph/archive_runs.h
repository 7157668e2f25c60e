#pragma once
#include <string>
#include <vector>

#include "roomgraph/archive/Archive.h"

namespace roomgraph {

/** The files of at most `most` runs of a site, as 'archive add' chooses those that it compares
 *  with; tells on stderr of those that are gone. */
std::vector<std::string> recordFiles(const Archive& archive, const std::string& site,
                                     std::size_t most);

/** The file of a run as somebody calls it, see namedRun. @throws DataError where there is no such
 *  run, or its file is gone or another one now. */
std::string fileOfRun(const Archive& archive, const std::string& site, const std::string& run,
                      const std::string& archiveFile);

}  // namespace roomgraph
