#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "roomgraph/breaks/MapBreak.h"

namespace roomgraph {

/** How many scans are shown before a break, or a place that is drawn twice, and as many behind. */
constexpr std::size_t kFramesAtBreak = 10;

/** The scans that are shown of a break: places from `first` to before `end` in those of its run,
 *  and the first `behind` it. */
struct FramesAtBreak {
  std::size_t first = 0, behind = 0, end = 0;
};

/** Of the scans of a run, which know the number of their `keyFrame`. None for a break without key
 *  frame, or one that the run does not have. O(scans). */
template <class Scan>
FramesAtBreak framesAtBreak(const MapBreak& tear, const std::vector<Scan>& scans) {
  const auto behind = std::find_if(scans.begin(), scans.end(), [&](const Scan& scan) {
    return tear.keyFrame && scan.keyFrame >= *tear.keyFrame;
  });
  if (behind == scans.end()) return {};
  const auto k = std::size_t(behind - scans.begin());
  return {k - std::min(k, kFramesAtBreak), k, std::min(scans.size(), k + kFramesAtBreak)};
}

}  // namespace roomgraph
