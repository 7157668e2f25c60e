#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "roomgraph/check/RunCheck.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

/** Two scans of a run that have drawn one place at two times, by their numbers. */
struct ScanPair {
  std::size_t one = 0, other = 0;  ///< in their order
  double apart = 0;                ///< how far the place lies from itself, where that is told [m]
};

inline ScanPair scanPair(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

/** How far scans lie from each other along the way of the run as drawn. */
class PathOfRun {
 public:
  explicit PathOfRun(const std::vector<ScanWalls>& scans) : path_(drivenWays(scans)) {}

  /** Whether the scans of two pairs lie within one pass of each other, at both times. */
  [[nodiscard]] bool areBeside(const ScanPair& l, const ScanPair& r) const {
    return areBeside(l.one, r.one) && areBeside(l.other, r.other);
  }
  /** Pairs that lie beside each other, directly or by others between them. O(pairs^2). */
  [[nodiscard]] std::vector<std::vector<ScanPair>> grouped(
      const std::vector<ScanPair>& pairs) const;

 private:
  [[nodiscard]] bool areBeside(std::size_t l, std::size_t r) const;

  std::vector<double> path_;  // to each scan [m]
};

/** From the first to the last scan on one side of some pairs; `at` is the one that is named. */
DrawnStretch stretchOf(const Run& run, const std::vector<ScanPair>& pairs,
                       std::size_t ScanPair::*side, std::size_t at);

}  // namespace roomgraph
