#include "aliasing.h"

#include <algorithm>
#include <optional>

#include "fitted_consensus.h"
#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {
namespace {

constexpr std::size_t kLookedAt = 80;  // patches

/** The share of the walls around a patch that lie on walls once it was fitted there, if the map
 *  knows most of that place. */
std::optional<double> shareFound(const WallPatch& patch, const Transform2D& motion,
                                 const WallMap& map) {
  const auto pointAt = [&](std::size_t i) -> const WallPoint& {
    return map.walls[patch.around[i]];
  };
  const Transform2D pose = fittedPose(motion, patch.middle, kPatchBand, [&](WallFit& fit, int) {
    for (std::size_t i = 0; i < patch.around.size(); ++i) fit.add(pointAt(i), map);
  });
  const WallShare share = wallShare(patch.around.size(), pointAt, map, pose);
  if (share.known < 0.6 * share.all || share.known < double(kFewestPoints)) return std::nullopt;
  return share.ofKnown();
}

}  // namespace

double aliasingUnder(const Transform2D& motion, const WallMap& map) {
  const std::size_t stride = std::max<std::size_t>(1, map.patches.size() / kLookedAt);
  double known = 0, alike = 0;
  for (std::size_t p = 0; p < map.patches.size(); p += stride)
    if (const auto share = shareFound(map.patches[p], motion, map))
      ++known, alike += *share > fitted::kWell;
  return known > 0 ? alike / known : 0;
}

}  // namespace roomgraph
