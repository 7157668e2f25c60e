#pragma once
#include <string>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

/** The bytes as a file holds them: as they are, as one gzip member without a time stamp, or as one
 *  zstd frame with size and checksum. CheckedFile reads them back. Same bytes, same file. O(bytes).
 *  @throws std::length_error for more than 4 GB as gzip. */
std::string compressed(const std::string& bytes, Compression how);

}  // namespace roomgraph
