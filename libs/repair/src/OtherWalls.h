#pragma once
#include <vector>

#include "roomgraph/align/find_scan.h"
#include "roomgraph/consensus/site_consensus.h"

namespace roomgraph {

/** What the runs of a site but one have seen near some places, where it really lies. */
class OtherWalls {
 public:
  /** `places`: in the frame of the site. Copies of the run do not count. O(scans * places + walls
   *  near by). */
  OtherWalls(const SolvedSite& solved, std::size_t but, const std::vector<Point>& places);

  /** How much speaks for a scan to lie at a pose (site <- robot), see ScanFit; 0 where no other run
   *  has been. */
  double scoreAt(const LocalScan& scan, const Transform2D& pose) const {
    return map_.walls.empty() ? 0 : fitAt(scan, map_, pose).score;
  }
  /** The same where a few steps from there lead to. */
  double scoreNear(const LocalScan& scan, const Transform2D& pose) const {
    return map_.walls.empty() ? 0 : fitNear(scan, map_, pose).score;
  }

 private:
  WallMap map_;
};

}  // namespace roomgraph
