#include "scan_disagreement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "MeasuredValue.h"
#include "fitted_measures.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/majority.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/PairBend.h"

namespace roomgraph {
namespace {

/** The scans that see what this one sees, but at another time. */
std::vector<std::size_t> othersOf(std::size_t scan, const std::vector<ScanWalls>& scans,
                                  const std::vector<double>& paths) {
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t j = 0; j < scans.size(); ++j) {
    const double far = distance(scans[scan].robot(), scans[j].robot());
    if (far <= fitted::kSameView && std::abs(paths[scan] - paths[j]) >= kWayRound)
      others.push_back({far, j});
  }
  std::sort(others.begin(), others.end());
  if (others.size() > fitted::kMaxVisits) others.resize(fitted::kMaxVisits);
  std::vector<std::size_t> numbers;
  for (const auto& [far, j] : others) numbers.push_back(j);
  return numbers;
}

/** Squared distance to the nearest wall of a scan, if that is below `best`. */
void searchIn(const ScanWalls& scan, const WallPoint& wall, std::optional<double>& best) {
  for (const WallPoint& other : scan.walls) {
    const Point off = other.place - wall.place;
    if (squaredNorm(off) > WallMap::kReach * WallMap::kReach) continue;
    if (dot(other.normal, wall.normal) < kFacesAlike) continue;
    const double across = dot(off, other.normal);
    const double along = std::max(0.0, std::abs(cross(off, other.normal)) - kSameWall);
    const double far = across * across + along * along;
    if (!best || far < *best) best = far;
  }
}

}  // namespace

Figure scanDisagreement(const std::vector<ScanWalls>& scans) {
  const std::vector<double> paths = drivenWays(scans);
  std::vector<double> medians;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::vector<std::size_t> others = othersOf(i, scans, paths);
    if (others.empty()) continue;
    std::vector<double> distances;
    double asked = 0;
    for (std::size_t k = 0; k < scans[i].walls.size(); k += 2) {  // half of them will do
      ++asked;
      std::optional<double> best;
      for (const std::size_t j : others) searchIn(scans[j], scans[i].walls[k], best);
      if (best) distances.push_back(std::sqrt(*best));
    }
    if (double(distances.size()) < kFewestThings || double(distances.size()) < kMajority * asked)
      continue;
    medians.push_back(lowerQuantile(std::move(distances), 0.5));
  }
  if (medians.empty()) return {};
  const double count = double(medians.size());
  return {lowerQuantile(std::move(medians), 0.9), count};
}

}  // namespace roomgraph
