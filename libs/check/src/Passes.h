#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/scan_map.h"

namespace roomgraph {

/** A stretch of a run, and what it has drawn. */
struct Pass {
  std::size_t first = 0, end = 0;  ///< scans
  WallMap map;
};

/** A run as it came by at one time and another: cut into stretches of a few metres of path, each of
 *  which draws a map, and which of them a scan of another time is to be held against. */
class Passes {
 public:
  static constexpr double kLength = 8;           ///< path of the scans of one [m]
  static constexpr std::size_t kLeastScans = 3;  ///< of one

  /** `poses` say where the scans lie. O(scans * cells around a few scans). */
  Passes(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses);

  [[nodiscard]] const std::vector<Pass>& all() const { return passes_; }
  /** The nearest ones that were drawn far from a scan in path: at most two of `all`. */
  [[nodiscard]] const std::vector<std::size_t>& besideScan(std::size_t k) const {
    return beside_[k];
  }
  /** Along the path between two scans [m]. */
  [[nodiscard]] double pathBetween(std::size_t from, std::size_t to) const {
    return path_[to] - path_[from];
  }
  /** The scan of a pass that lies nearest to a place, the first of equals. */
  [[nodiscard]] std::size_t nearestScan(const Pass& pass, Point place) const;
  /** How far from where it lies a scan may be by the path between it and a pass. */
  [[nodiscard]] PoseTolerance windowOf(std::size_t k, const Pass& pass) const;

 private:
  void cut();
  void chooseFor(std::size_t k);
  [[nodiscard]] double pathTo(std::size_t k, const Pass& pass) const;

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& poses_;
  std::vector<double> path_;  // to each scan [m]
  std::vector<Pass> passes_;
  std::vector<std::vector<std::size_t>> beside_;  // of each scan
};

}  // namespace roomgraph
