#include "roomgraph/check/ScanPair.h"

#include "Passes.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {

bool PathOfRun::areBeside(std::size_t l, std::size_t r) const {
  return path_[std::max(l, r)] - path_[std::min(l, r)] < Passes::kLength;
}

std::vector<std::vector<ScanPair>> PathOfRun::grouped(const std::vector<ScanPair>& pairs) const {
  UnionFind joined(pairs.size());
  for (std::uint32_t i = 0; i < pairs.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (areBeside(pairs[i], pairs[j])) joined.join(i, j);
  return mapped(joined.sets(), [&](const std::vector<std::size_t>& set) {
    return mapped(set, [&](std::size_t i) { return pairs[i]; });
  });
}

DrawnStretch stretchOf(const Run& run, const std::vector<ScanPair>& pairs,
                       std::size_t ScanPair::*side, std::size_t index) {
  const ScanWalls& scan = run.scans[index];
  DrawnStretch stretch{scan.keyFrame, scan.keyFrame, scan.keyFrame, scan.time, scan.robot()};
  for (const ScanPair& pair : pairs) {
    const std::size_t keyFrame = run.scans[pair.*side].keyFrame;
    stretch.first = std::min(stretch.first, keyFrame);
    stretch.last = std::max(stretch.last, keyFrame);
  }
  return stretch;
}

}  // namespace roomgraph
