#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <string>

namespace roomgraph::test {

/** How a newer MRPT writes a simplemap. */
struct Newer {
  int mapVersion = 2;
  bool hasTwist = false;  ///< how fast the robot was
  int scanVersion = 8;
  bool hasComments = false;     ///< MOLA puts one into each frame
  bool hasEmptyFrames = false;  ///< one without observations after each
};

/** The bytes of the map as a newer MRPT would have written them, put together from those of this
 *  one, object by object. */
std::string asNewer(const mrpt::maps::CSimpleMap& map, const Newer& how);

/** What stands behind each entry from version 2 on. */
std::string twistBytes(bool hasTwist);

/** A simplemap around entries whose bytes are given. */
std::string simplemapBytes(int version, const std::vector<std::string>& entries);

/** The bytes of a frame around the bytes of its observations. */
std::string frameBytes(const std::vector<std::string>& observations);

}  // namespace roomgraph::test
