#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/align/WallPoint.h"

namespace roomgraph {

/** The walls of one square of a map, and what holds them in place. */
struct WallPatch {
  Point middle;                    ///< mean of its own walls [m, map frame]
  std::vector<std::uint32_t> own;  ///< its wall points, as indices of all of them
  /** Some of those up to two squares' sides from `middle`, which hold shift and turn: evenly, its
   *  own among them. */
  std::vector<std::uint32_t> around;
  std::vector<std::uint32_t> neighbours;  ///< patches of the squares beside it, ascending
};

using WallPatches = std::vector<WallPatch>;  ///< by column, then by row

constexpr double kPatchSide = 2;  ///< of a square [m]
constexpr int kMaxAround = 60;    ///< points of `around`

/** Cuts the walls of a map into patches, by column, then row of squares. Each wall point belongs to
 *  exactly one. O(walls * walls within reach). */
[[nodiscard]] WallPatches wallPatches(const std::vector<WallPoint>& walls);

}  // namespace roomgraph
