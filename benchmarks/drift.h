#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "walk.h"

namespace roomgraph {

// In:   the true poses of a robot
// Out:  the poses it would believe in, had it only its wheels and no luck
// Next: simulateScans

struct DriftOptions {
  double turnPerMetre = 0;             ///< by which it turns without noticing [rad/m]
  double turnNoise = 0;                ///< the same at random, after one metre [rad]
  std::optional<std::size_t> breakAt;  ///< the pose at which its heading jumps; none without a jump
  double breakTurn = 0;                ///< by how much [rad]
  std::uint32_t seed = 1;
};

/** One pose per true one, from `start` on. Each step is right but for the errors above, which are
 *  never corrected; without them the poses are the true ones in the frame of `start`. No poses for
 *  none. */
std::vector<Transform2D> drift(const std::vector<WalkPose>& poses, const Transform2D& start,
                               const DriftOptions& options);

}  // namespace roomgraph
