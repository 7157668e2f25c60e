#pragma once
#include <string>

namespace roomgraph {

// Ours
// In:   a map file
// Out:  the name of a copy of it
// Next: addRun

/** Copies a map, and the picture of a ROS map, to a folder of its own in `folder`, which is named
 *  after its content, and returns the name of the copy. What is there already stays. `sha256` is
 *  what the content should be, see mapSha256. Written so that a copy is whole or not there.
 *  @throws DataError where it cannot be read or written, is another map now, or names a picture
 *  outside of its folder. */
std::string keepMap(const std::string& file, const std::string& sha256, const std::string& folder);

}  // namespace roomgraph
