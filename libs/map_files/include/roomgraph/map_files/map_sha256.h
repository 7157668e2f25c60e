#pragma once
#include <string>

namespace roomgraph {

// In:   a map file
// Out:  what GreyMap has as the hash of its source
// Next: -

/** GreyMap::source.sha256 of the map, without building it: of the file's bytes, and of those of the
 *  picture of a ROS map, too. It does not tell whether the file is a map at all. O(file).
 *  @throws DataError where the file, or the picture, cannot be read. */
[[nodiscard]] std::string mapSha256(const std::string& name);

/** The picture that a ROS map names; empty for any other map. @throws DataError like mapSha256. */
[[nodiscard]] std::string pictureOfMap(const std::string& name);

}  // namespace roomgraph
