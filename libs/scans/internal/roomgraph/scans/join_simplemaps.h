#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/StoredPose.h"

namespace roomgraph {

// Ours
// In:   simplemaps
// Out:  one simplemap with the key frames of all
// Next: compressed, writeFileAtomically

/** The content of a simplemap, and which of its key frames are taken. */
struct SimplemapPart {
  std::string content;              ///< with the poses that its key frames are to have
  StoredPoses stored;               ///< of the content
  std::vector<std::size_t> frames;  ///< ascending
};

/** The content of one simplemap with the key frames of several, part by part, byte for byte. It has
 *  the version of the newest part: in version 2, those of older ones do not tell how fast the robot
 *  was. Nothing for no parts. O(bytes). */
std::string joinSimplemaps(const std::vector<SimplemapPart>& parts);

}  // namespace roomgraph
