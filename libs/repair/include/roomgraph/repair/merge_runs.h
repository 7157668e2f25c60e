#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomgraph/base/ForEach.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

// In:   the scans of all runs, where they really lie
// Out:  MergedMap
// Next: binarize, extract

/** The scans of a run on their way into the map of the site. */
struct MergedRun {
  std::string name;
  std::vector<Keyframe> scans;  ///< with the poses that they really have: site <- robot
  std::optional<double> time;   ///< when it was made [s since 1970]
  /** Where it has drawn its scans, run <- robot: what it holds together is left out together. Empty
   *  where they have not been moved. */
  std::vector<Transform2D> drawn{};
};

struct MergeOptions {
  double resolution = 0.05;    ///< side of a cell [m]
  bool prefersLatest = false;  ///< each run counts twice as much as the one made before it
};

/** One map of a site that several runs have made. */
struct MergedMap {
  GreyMap map;                     ///< in the frame of the site
  std::vector<std::uint8_t> runs;  ///< of each cell: how many runs have seen it, up to 255
  std::vector<float> time;         ///< of each cell: when it was seen last [days before the latest
                                   ///< run]; negative where no run that saw it tells a time
  /** What was left out: for each run the scans that contradict what the others see, by their
   *  places in `scans`. */
  std::vector<std::vector<std::size_t>> leftOut;
};

/** Draws one map of all scans. Each run has a vote on each cell that its beams have met or passed:
 *  wall by the share that ended there. A cell is wall where the votes are, and, where the two runs
 *  made last have the same to say, as they say: so people, moved chairs and doubled walls go. Scans
 *  in the wrong place are left out first. Others contradict a beam that ends where they look
 *  through, or goes through what is wall to them, but not what the two runs made last agree on; and
 *  a scan by more than a quarter of its beams of which they know, or twice the usual share in its
 *  run. With it go those beside it of which nobody knows, and its piece of the run, if most of that
 *  is left out. The same for any order of the runs of different times.
 *  O(beams * their lengths).
 *  @throws DataError where they reach over more cells than a map may have, UsageError where a run
 *  has drawn other scans than it has. */
[[nodiscard]] MergedMap mergeRuns(const std::vector<MergedRun>& runs, const MergeOptions& options,
                                  const ForEach& forEach);

}  // namespace roomgraph
