#pragma once
#include <cstddef>
#include <vector>

#include "roomgraph/consensus/Consensus.h"
#include "roomgraph/relate/Site.h"

namespace roomgraph {

/** Where the places of one run really lie in the site: each as the key frame does that has drawn
 *  most beside it; of a run without scans, as the run does as a whole. */
class RealPlaces {
 public:
  /** `frame`: site <- frame of the consensus. O(area of the map + walls of all scans). */
  RealPlaces(const Site& site, const Consensus& consensus, const Transform2D& frame,
             std::size_t run);

  /** At a place of the run [m, run frame]: site <- run. O(1). */
  [[nodiscard]] const Motion2D& at(Point place) const;

 private:
  GridFrame tiles_;                ///< of the map of the run that counts for it
  std::vector<Motion2D> motions_;  ///< site <- run, per tile
  Transform2D copied_;             ///< that run <- run
};

/** site <- frame of the consensus, which has the most trusted run, or of equal ones that with the
 *  least error, as near as can be to where it lies in the site. The identity where no run has
 *  scans. O(key frames). */
Transform2D frameOfConsensus(const Site& site, const Consensus& consensus, const Trust& trust);

}  // namespace roomgraph
