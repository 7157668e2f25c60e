#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/geometry/PlanarCovariance.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/scans/Recording.h"

namespace roomgraph {

// In:   the content of simplemaps, and how key frames are to be moved
// Out:  the content of the moved one, or of one with the key frames of all
// Next: compressed, writeFileAtomically

/** What becomes of the pose of a key frame. */
struct PoseMove {
  Transform2D motion;  ///< new map <- old map; applied to the mean, and to each particle
  /** Takes the place of the stored one: its block of x, y and yaw, while those of height, pitch and
   *  roll stay and no longer depend on it. Particles have none. */
  std::optional<PlanarCovariance> covariance;
};

/** The content with other poses, byte for byte the same but for these; one `moves` for each key
 *  frame. All layouts of poses that readPoseMean knows. O(file).
 *  @throws DataError where the content is not that of the recording. */
std::string movePoses(ByteView content, const Recording& recording,
                      const std::vector<PoseMove>& moves);

/** The content of a simplemap with a key frame or more, and which of these are taken. */
struct SimplemapPart {
  std::string content;              ///< with the poses that its key frames are to have
  Recording recording;              ///< of the content; what was seen may be gone from it
  std::vector<std::size_t> frames;  ///< ascending
};

/** The content of one simplemap with the key frames of several, part by part, byte for byte. It has
 *  the version of the newest part: in version 2, those of older ones do not tell how fast the robot
 *  was. Nothing for no parts. O(bytes). */
std::string joinSimplemaps(const std::vector<SimplemapPart>& parts);

}  // namespace roomgraph
