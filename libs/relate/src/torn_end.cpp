#include "torn_end.h"

#include <algorithm>

#include "fitted_relate.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/sight_walls.h"

namespace roomgraph {
namespace {

std::vector<std::uint32_t> contradicted(const WallMap& map, const WallMap& other,
                                        const FollowedWalls& followed,
                                        const std::vector<bool>& isFound) {
  const std::vector<WallSighting> seen = sightWalls(map, other, followed);
  std::vector<std::uint32_t> walls;
  for (std::uint32_t k = 0; k < seen.size(); ++k)
    if (seen[k] == WallSighting::free && !isFound[k]) walls.push_back(k);
  return walls;
}

/** The patches that have one of some walls, which are ascending, as their own. */
std::vector<std::uint32_t> patchesWith(const std::vector<std::uint32_t>& walls,
                                       const WallPatches& patches) {
  const auto isOne = [&](std::uint32_t k) {
    return std::binary_search(walls.begin(), walls.end(), k);
  };
  std::vector<std::uint32_t> found;
  for (std::uint32_t patch = 0; patch < patches.size(); ++patch)
    if (anyOf(patches[patch].own, isOne)) found.push_back(patch);
  return found;
}

/** Where a scan fits, if in one place only. */
std::optional<ScanFit> placeOf(const LocalScan& scan, const WallMap& other,
                               const Transform2D& drawn) {
  const auto fits = findScan(scan, other, drawn, {M_PI, kRoughly.place}, kTries);
  const auto best = bestOf(fits);
  if (best == fits.end() || best->quality < kMajority || best->known < kSureQuality ||
      best->hold < fitted::kTornHold)
    return std::nullopt;
  const bool isAmbiguous = anyOf(fits, [&](const ScanFit& fit) {
    return fit.score > kRivalScore * best->score && !areNear(fit.pose, best->pose, {}, kSameAnswer);
  });
  return isAmbiguous ? std::nullopt : std::optional(*best);
}

/** Whether what was found of a map fits at a pose, too, at least half as well as its torn end does:
 *  then the building repeats itself, as pews and desks do, and nothing is torn off. Of true ends
 *  with two records of thirteen sites the rest fits up to 0.46 times as well. */
bool isRepeated(const WallMap& map, const WallMap& other, const std::vector<bool>& isFound,
                const Transform2D& pose, double quality) {
  const auto isChosen = [&](std::size_t k) { return isFound[k]; };
  const WallShare share = shareOfChosen(map, isChosen, other, pose);
  return share.found >= kMajority * quality * share.known;
}

}  // namespace

std::optional<TornEnd> findTornEnd(const WallMap& map, const WallMap& other,
                                   const FollowedWalls& followed,
                                   const std::vector<bool>& isFound) {
  const std::vector<std::uint32_t> walls = contradicted(map, other, followed, isFound);
  if (walls.size() < fitted::kFewestContradicted) return std::nullopt;
  Point sum;
  for (const std::uint32_t k : walls) sum = sum + map.walls[k].place;
  const Point middle = 1 / double(walls.size()) * sum;
  LocalScan stretch;  // as seen from its middle
  for (const std::uint32_t k : walls)
    stretch.walls.push_back({map.walls[k].place - middle, map.walls[k].normal});
  const Transform2D toMiddle{middle.x, middle.y, 0};
  const auto place = placeOf(stretch, other, followed.pose * toMiddle);
  if (!place) return std::nullopt;
  const Transform2D pose = place->pose * toMiddle.inverse();
  if (isRepeated(map, other, isFound, pose, place->quality)) return std::nullopt;
  return TornEnd{patchesWith(walls, map.patches), pose};
}

}  // namespace roomgraph
