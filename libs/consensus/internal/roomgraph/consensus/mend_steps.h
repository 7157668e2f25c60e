#pragma once
#include <vector>

#include "roomgraph/align/find_scan.h"

namespace roomgraph {

// In:   the scans of a run, and where the run has drawn them
// Out:  MendedSteps
// Next: findRevisits, ownMatches, heldSteps

/** What a scan and those before it, which see the same walls, say of the step between them. */
enum class StepEvidence {
  none,         ///< too little is seen by both
  agrees,       ///< the scan fits where it was drawn
  contradicts,  ///< it fits better elsewhere, and only there
  lost          ///< it does not fit where it was drawn, and elsewhere in no place or in several
};

inline bool speaksAgainst(StepEvidence evidence) {
  return evidence == StepEvidence::contradicts || evidence == StepEvidence::lost;
}

/** A run whose steps are as its own scans have them. */
struct MendedSteps {
  std::vector<Transform2D> poses;      ///< of each scan; as drawn up to the first contradiction
  std::vector<StepEvidence> evidence;  ///< of the step to each scan; none for the first
};

/** Fits each scan into the map of the few before it: where it was drawn and, where it does not fit
 *  there, at any turn about the place where the robot has just been; where that leaves it nowhere,
 *  into what all scans before have drawn about that place. A scan that fits about as well
 *  where it was drawn is left there, so a corridor on which it may slide contradicts nothing. Where
 *  that leaves a step as it was, the one scan before it is held against the few behind it, which
 *  tells slips that the next step takes back: the scan between lies wrong, and both steps do. Turns
 *  that this and the scan behind the step, held against those before it, tell alike count sooner.
 *  Only the steps to the scans that are `asked` for are held against others, where there are such;
 *  of the others there is no evidence.
 *  Deterministic. O(scans + asked * (cells around a few scans)). */
MendedSteps mendSteps(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
                      const std::vector<bool>& asked = {});

}  // namespace roomgraph
