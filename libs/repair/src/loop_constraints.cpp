#include "roomgraph/repair/loop_constraints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "fitted_repair.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/NearPlaces.h"

namespace roomgraph {

std::string molaConstraints(const Run& run, const std::vector<Transform2D>& real) {
  const std::vector<double> path = drivenWays(run.scans);
  const std::vector<Point> places = mapped(real, &Transform2D::shift);
  const NearPlaces near(places, fitted::kSameSpot);
  const std::vector<bool> hasOwnTime = haveOwnTimes(run.scans);
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;  // the nearest first
  for (std::size_t k = 0; k < places.size(); ++k)
    near.forEachNear(places[k], [&](std::uint32_t other) {
      const double apart = distance(places[k], places[other]);
      if (other > k && apart <= fitted::kSameSpot && path[other] - path[k] >= kWayRound &&
          hasOwnTime[k] && hasOwnTime[other])
        pairs.emplace_back(apart, k, other);
    });
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> isTaken(places.size());
  std::map<std::size_t, std::string> lines;  // by the first scan
  for (const auto& [apart, from, to] : pairs) {
    if (isTaken[from] || isTaken[to]) continue;
    isTaken[from] = isTaken[to] = true;
    lines[from] = formatted(
        "  - {timestamp_i: %.6f, timestamp_j: %.6f, sigma_xyz: %.3f, trust_as_inlier: true}\n",
        *run.scans[from].time, *run.scans[to].time, std::hypot(fitted::kLeastSpread, apart));
  }
  std::string text = lines.empty() ? "manual_loop_constraints: []\n" : "manual_loop_constraints:\n";
  for (const auto& [from, line] : lines) text += line;
  return text;
}

std::vector<bool> haveOwnTimes(const std::vector<ScanWalls>& scans) {
  std::map<double, std::size_t> keyFrames;  // by their times
  std::set<double> shared;
  for (const ScanWalls& scan : scans)
    if (scan.time && keyFrames.emplace(*scan.time, scan.keyFrame).first->second != scan.keyFrame)
      shared.insert(*scan.time);
  return mapped(scans, [&](const ScanWalls& s) { return s.time && shared.count(*s.time) == 0; });
}

}  // namespace roomgraph
