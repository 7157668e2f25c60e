#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

/** A pose of a key frame as a simplemap stores it, and where. */
struct StoredPose {
  std::size_t begin = 0;          ///< first byte of the key frame, where its pose's object begins
  std::size_t end = 0;            ///< behind the last byte of the key frame
  std::array<double, 3> place{};  ///< map <- robot, mean [m]
  std::array<double, 4> turn{0, 0, 0, 1};  ///< the same as a quaternion, x y z w
  std::optional<double> time;  ///< of its first scan or cloud that has one [s since 1970, UTC]
};

/** All of a simplemap, in the order of the file. */
struct StoredPoses {
  int mapVersion = 0;       ///< of CSimpleMap
  std::size_t headEnd = 0;  ///< where the first key frame begins, behind their number
  std::vector<StoredPose> frames;
};

/** The poses of all key frames of a simplemap, those without a scan, too, and the places of their
 *  bytes in its content. Checks as loadGrid does. O(file).
 *  @throws DataError where the file is damaged or no simplemap. */
StoredPoses readStoredPoses(CheckedFile& file);

}  // namespace roomgraph
