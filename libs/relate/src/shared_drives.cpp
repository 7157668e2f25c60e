#include "roomgraph/relate/shared_drives.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/relate/shares_drive.h"

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

}  // namespace

std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs) {
  UnionFind drives(runs.size());
  for (const auto& [pair, same] : commonScans(runs)) {
    const auto& [a, b] = pair;
    if (sharesDrive(same, std::min(runs[a]->scans.size(), runs[b]->scans.size())))
      drives.join(a, b);
  }
  std::vector<std::vector<std::size_t>> sets(runs.size());
  for (std::uint32_t i = 0; i < runs.size(); ++i) sets[drives.find(i)].push_back(i);
  std::vector<std::vector<std::size_t>> shared;
  for (std::vector<std::size_t>& set : sets)
    if (set.size() > 1) shared.push_back(std::move(set));
  return shared;
}

}  // namespace roomgraph
