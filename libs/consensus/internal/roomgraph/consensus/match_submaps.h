#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/consensus/drawn_by.h"
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

/** What of one run was found in another in one piece: right or wrong, it is so together. */
struct MatchedPiece {
  std::vector<SubmapMatch> matches;  ///< by submap
  /** How much the other map looks alike here and where another piece of the run was found, 0 to 1:
   *  in a building that repeats itself, finding a piece elsewhere than the rest says little. */
  double likeness = 0;
};

/** The map of a run, and which of its submaps drew what of it. */
struct DrawnMap {
  const WallMap& map;  ///< not bare
  const RunSubmaps& submaps;
  const DrawnBy& drawnBy;
};

/** Finds each submap of `of` in the map of another run: scans by trackScans, patches as they were
 *  `followed`; `wholes` (in <- of) is where the runs may lie as a whole, the likeliest first.
 *  Submaps of which less than 45 % lies on walls there are not found. The pieces are the stretches
 *  of a track between its jumps, or the layers in which patches were followed. Cost: that of
 *  trackScans. */
std::vector<MatchedPiece> matchSubmaps(const Run& of, const RunSubmaps& ofSubmaps,
                                       const DrawnMap& in, const FollowedWalls& followed,
                                       const std::vector<Transform2D>& wholes);

/** The scans that both runs have, as runs over one log do. O((a + b) * log b). */
std::vector<SubmapMatch> sameScans(const Run& a, const Run& b);

}  // namespace roomgraph
