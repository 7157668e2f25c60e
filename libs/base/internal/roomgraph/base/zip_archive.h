#pragma once
#include <string>
#include <utility>
#include <vector>

namespace roomgraph {

/** A ZIP archive with these files (name, bytes) in this order, stored as they are and without a
 *  time, so that the same files give the same archive. O(bytes).
 *  @throws std::length_error for more than 65535 files, or more than 4 GB. */
std::string zipArchive(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace roomgraph
