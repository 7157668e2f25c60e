#include "roomgraph/consensus/shared_drives.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/consensus/match_submaps.h"

namespace roomgraph {
namespace {

/** The later run first; by that, then by the other. */
std::set<std::pair<std::uint32_t, std::uint32_t>> runsWithCommonScans(
    const std::vector<const Run*>& runs) {
  std::unordered_map<std::uint64_t, std::set<std::uint32_t>> withScan;
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t a = 0; a < runs.size(); ++a)
    for (const ScanWalls& scan : runs[a]->scans) {
      std::set<std::uint32_t>& others = withScan[scan.scanId];
      for (const std::uint32_t b : others)
        if (b != a) pairs.insert({a, b});
      others.insert(a);
    }
  return pairs;
}

}  // namespace

std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs) {
  UnionFind drives(runs.size());
  const auto haveCommon = runsWithCommonScans(runs);
  for (const auto& [a, b] : haveCommon) {
    if (drives.find(a) == drives.find(b)) continue;
    const std::size_t fewer = std::min(runs[a]->scans.size(), runs[b]->scans.size());
    const auto same = double(sameScans(*runs[a], *runs[b]).size());
    if (same > kSharedDrive * double(fewer)) drives.join(a, b);
  }
  std::vector<std::vector<std::size_t>> sets(runs.size());
  for (std::uint32_t i = 0; i < runs.size(); ++i) sets[drives.find(i)].push_back(i);
  std::vector<std::vector<std::size_t>> shared;
  for (std::vector<std::size_t>& set : sets)
    if (set.size() > 1) shared.push_back(std::move(set));
  return shared;
}

}  // namespace roomgraph
