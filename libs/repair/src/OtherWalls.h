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

  /** How a scan fits at a pose (site <- robot); not at all where no other run has been. */
  ScanFit at(const LocalScan& scan, const Transform2D& pose) const {
    return map_.walls.empty() ? ScanFit{pose} : fitAt(scan, map_, pose);
  }
  /** The same where a few steps from there lead to. */
  ScanFit near(const LocalScan& scan, const Transform2D& pose) const {
    return map_.walls.empty() ? ScanFit{pose} : fitNear(scan, map_, pose);
  }

 private:
  WallMap map_;
};

}  // namespace roomgraph
