#pragma once
#include <string>

#include "roomgraph/graph_files/GraphFile.h"

namespace roomgraph {

/** Reads a roomgraph/graph version 1 file. Fields that version 1 does not know are skipped.
 *  @throws DataError with one line (file, problem, remedy) where it is missing, damaged, of another
 *  format or version, or names a vertex or room that it does not hold. */
[[nodiscard]] GraphFile readGraphJson(const std::string& path);

/** The same for the text of a file; `name` is its name for messages. */
[[nodiscard]] GraphFile parseGraphJson(const std::string& text, const std::string& name);

}  // namespace roomgraph
