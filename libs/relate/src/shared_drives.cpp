#include "roomgraph/relate/shared_drives.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "fitted_relate.h"
#include "roomgraph/align/FullMaps.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/MotionFit.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

using PairOfRuns = std::pair<std::uint32_t, std::uint32_t>;  // the later one first

/** For each two runs that have scans in common, how many of the later one. */
std::map<PairOfRuns, std::size_t> commonScans(const std::vector<const Run*>& runs) {
  std::unordered_map<std::uint64_t, std::set<std::uint32_t>> withScan;
  std::map<PairOfRuns, std::size_t> common;
  for (std::uint32_t a = 0; a < runs.size(); ++a)
    for (const ScanWalls& scan : runs[a]->scans) {
      if (scan.ends.count <= 0) continue;
      std::set<std::uint32_t>& others = withScan[scan.scanId];
      for (const std::uint32_t b : others)
        if (b != a) ++common[{a, b}];
      others.insert(a);
    }
  return common;
}

/** Where two runs have drawn a scan that both have. */
struct CommonScan {
  Transform2D inA, inB;

  Transform2D bInA() const { return inA * inB.inverse(); }
};

std::vector<CommonScan> commonScans(const Run& a, const Run& b) {
  std::unordered_map<std::uint64_t, const ScanWalls*> ofA;
  for (const ScanWalls& scan : a.scans)
    if (scan.ends.count > 0) ofA.emplace(scan.scanId, &scan);
  std::vector<CommonScan> common;
  for (const ScanWalls& scan : b.scans)
    if (const auto same = ofA.find(scan.scanId); scan.ends.count > 0 && same != ofA.end())
      common.push_back({same->second->pose, scan.pose});
  return common;
}

/** a <- b that most of the scans agree with: of a torn run, the larger part. */
Transform2D poseOf(const std::vector<CommonScan>& common) {
  Transform2D pose = common[common.size() / 2].bInA();
  for (int round = 0; round < 10; ++round) {
    MotionFit fit;
    for (const CommonScan& scan : common) {
      const double off = distance(pose(scan.inB.shift()), scan.inA.shift()) / fitted::kBendWidth;
      fit.add(scan.inB.shift(), scan.inA.shift(), 1 / (1 + off * off));
    }
    pose = fit.motion();
  }
  return pose;
}

/** The pair as its common scans have it: the pose of all, then those of some along the drive. */
MapPair joined(MapPair pair, const std::vector<CommonScan>& common, const WallMap& a,
               const WallMap& b) {
  std::vector<Transform2D> poses{poseOf(common)};
  for (std::size_t k = 0; k < fitted::kStarts; ++k)
    poses.push_back(common[k * common.size() / fitted::kStarts].bInA());
  pair.alignment = alignmentAt(a, b, poses);
  follow(pair, a, b, poses);
  return pair;
}

}  // namespace

std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs) {
  UnionFind drives(runs.size());
  for (const auto& [pair, same] : commonScans(runs)) {
    const auto& [a, b] = pair;
    if (sharesDrive(same, std::min(runs[a]->scans.size(), runs[b]->scans.size())))
      drives.join(a, b);
  }
  std::vector<std::vector<std::size_t>> shared;
  for (std::vector<std::size_t>& set : drives.sets())
    if (set.size() > 1) shared.push_back(std::move(set));
  return shared;
}

void joinDrives(MapPairs& related, const std::vector<Run>& runs, const ForEach& forEach) {
  const auto pointers = mapped(runs, [](const Run& run) { return &run; });
  std::vector<std::size_t> drive(runs.size());  // 0 for a run that shares none
  const auto drives = sharedDrives(pointers);
  for (std::size_t k = 0; k < drives.size(); ++k)
    for (const std::size_t run : drives[k]) drive[run] = k + 1;
  std::vector<PairOfThings> apart;
  for (const auto& [a, b] : related.pairs())
    if (drive[a] > 0 && drive[a] == drive[b] && !isJoined(related(a, b))) apart.emplace_back(a, b);
  forEach(apart.size(), [&](std::size_t i) {
    const auto [a, b] = apart[i];
    const auto common = commonScans(runs[a], runs[b]);
    if (common.empty()) return;  // they share scans with a third run only
    FullMaps maps;
    related(a, b) = joined(std::move(related(a, b)), common, maps(runs[a].map), maps(runs[b].map));
  });
}

}  // namespace roomgraph
