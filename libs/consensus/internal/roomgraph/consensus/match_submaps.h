#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/consensus/run_submaps.h"
#include "roomgraph/relate/follow_walls.h"

namespace roomgraph {

// Ours
// In:   two runs, and where the walls of the one lie in the other
// Out:  SubmapMatch
// Next: findConsensus

/** A submap of one run that was found in another run. */
struct SubmapMatch {
  std::uint32_t submap = 0;  ///< of the one run
  std::uint32_t in = 0;      ///< the submap of the other run that drew most of the walls it met
  Transform2D pose;          ///< in <- submap
  double weight = 0;         ///< 0 to 1: the share of its walls that were found
  bool isSameScan = false;   ///< both are one scan of one drive, so `pose` changes nothing
};

/** Finds each submap of `of` in the map of `in`: scans by trackScans, patches as they were
 *  `followed`; `whole` (in <- of) is where the runs lie as a whole. Submaps of which less than
 *  45 % lies on walls there are not found. By submap; a patch that was followed in two layers is
 *  found twice. Cost: that of trackScans. */
std::vector<SubmapMatch> matchSubmaps(const Run& of, const RunSubmaps& ofSubmaps, const Run& in,
                                      const RunSubmaps& inSubmaps, const FollowedWalls& followed,
                                      const Transform2D& whole);

/** The scans that both runs have, as runs over one log do. O((a + b) * log b). */
std::vector<SubmapMatch> sameScans(const Run& a, const Run& b);

}  // namespace roomgraph
