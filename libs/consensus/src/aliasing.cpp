#include "aliasing.h"

#include <algorithm>
#include <optional>

#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {
namespace {

constexpr std::size_t kLookedAt = 80;   // patches
constexpr double kPatchFound = 0.6;     // share of its walls from which on a patch looks alike
constexpr double kLeastLookedAt = 0.2;  // share of the patches that must lie on what is known

/** The share of the walls around a patch that lie on walls once it was fitted there, if the map
 *  knows most of that place. */
std::optional<double> shareFound(const WallPatch& patch, const Transform2D& motion,
                                 const WallMap& map) {
  const Motion2D forth(fittedPose(motion, patch.middle, kPatchBand, [&](WallFit& fit, int) {
    for (const std::uint32_t w : patch.around) fit.add(map.walls[w], map);
  }));
  double known = 0, found = 0;
  for (const std::uint32_t w : patch.around) {
    const Point at = forth(map.walls[w].place);
    const std::size_t cell = cellIndexAt(map.frame, at);
    if (!hasSeen(map, cell)) continue;
    ++known;
    if (const WallPoint* wall = nearestWall(map, cell, forth.turned(map.walls[w].normal)))
      found += 1 / (1 + squaredNorm(wall->place - at) / (kWallNoise * kWallNoise));
  }
  if (known < 0.6 * double(patch.around.size()) || known < 15) return std::nullopt;
  return found / known;
}

}  // namespace

double aliasingUnder(const Transform2D& motion, const WallMap& map) {
  const std::size_t stride = std::max<std::size_t>(1, map.patches.size() / kLookedAt);
  double all = 0, known = 0, alike = 0;
  for (std::size_t p = 0; p < map.patches.size(); p += stride, ++all)
    if (const auto share = shareFound(map.patches[p], motion, map))
      ++known, alike += *share > kPatchFound;
  return known > kLeastLookedAt * all ? alike / known : 0;
}

}  // namespace roomgraph
