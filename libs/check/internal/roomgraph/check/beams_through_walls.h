#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "roomgraph/align/LocalScan.h"
#include "roomgraph/check/RunCheck.h"
#include "roomgraph/check/ScanPair.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph {

// In:   the scans of a run, and where they lie
// Out:  BeamsThroughWalls
// Next: selfEvidence

/** Walls that stand where the run has seen free space at another time. */
struct BeamsThroughWalls {
  std::size_t walls = 0;    ///< whose place was seen at another time, once for each such pass
  std::size_t through = 0;  ///< of those: where beams have gone through
  /** The share of these; none of no walls. */
  std::optional<double> share() const {
    return walls > 0 ? std::optional(double(through) / double(walls)) : std::nullopt;
  }
  /** Scans of most of whose walls that is so, each with the nearest one of that pass. */
  std::vector<ScanPair> overlaid;
};

/** Holds the walls of each scan against the nearest passes that were drawn far from it in path. A
 *  wall that the pass has, too, though a little off, is not gone through. O(scans * (walls + cells
 *  around a few scans)). */
BeamsThroughWalls beamsThroughWalls(const std::vector<LocalScan>& scans,
                                    const std::vector<Transform2D>& poses);

/** Whether beams go through clearly more walls of a run where it would agree with itself: then what
 *  it agrees on is not right. */
bool seesThroughMore(const BeamsThroughWalls& drawn, const BeamsThroughWalls& agreed);

/** The places that the run has laid over each other though they are not one: where several
 *  scans beside each other see through most of the walls of another time, as drawn and as the run
 *  would agree with itself, which has not parted them. The largest first. O(overlaid^2). */
std::vector<WeldedPlace> findWelded(const Run& run, const BeamsThroughWalls& drawn,
                                    const BeamsThroughWalls& agreed);

}  // namespace roomgraph
