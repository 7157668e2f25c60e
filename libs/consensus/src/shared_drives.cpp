#include "roomgraph/consensus/shared_drives.h"

#include <algorithm>
#include <utility>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/consensus/match_submaps.h"

namespace roomgraph {

std::vector<std::vector<std::size_t>> sharedDrives(const std::vector<const Run*>& runs) {
  UnionFind drives(runs.size());
  for (std::uint32_t a = 0; a < runs.size(); ++a)
    for (std::uint32_t b = 0; b < a; ++b) {
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
