#pragma once
#include <optional>
#include <vector>

#include "roomgraph/align/alignment_hypotheses.h"
#include "roomgraph/align/verify_alignment.h"

namespace roomgraph {

// In:   two WallMap
// Out:  Alignment
// Next: sitePoses

/** A pose, and what speaks for it. */
struct AlignmentCandidate {
  Transform2D pose;  ///< a <- b
  AlignmentEvidence evidence;
  double score = 0;  ///< alignmentScore
};

/** How one map lies in another. */
struct Alignment {
  Transform2D pose;           ///< a <- b, the likeliest; nothing where there is no `best`
  double confidence = 0;      ///< the probability that `pose` is right, 0 to 1
  double siteConfidence = 0;  ///< the probability that both maps show the same building, 0 to 1
  double overlap = 0;         ///< share of the smaller map's free space that is free in both
  bool isSameSite = false;
  bool isOnlySaid = false;  ///< the same site is what the caller says, not what the maps show
  /** `b` fits far better as its own mirror image: then it does not show the same site. */
  bool isMirrored = false;
  bool isAmbiguous = false;  ///< the runner-up is about as good, as in a symmetric building
  std::optional<AlignmentCandidate> best;      ///< none where a map has no walls
  std::optional<AlignmentCandidate> runnerUp;  ///< the best that is not near `best`
  double runnerUpConfidence = 0;               ///< the probability that it is right instead
  std::vector<Transform2D> poses;  ///< all that were looked at closely, a <- b, best first
};

/** The same alignment with the maps named the other way round. */
Alignment inverse(Alignment alignment);

/** Finds how `b` lies in `a`, whatever its turn and with no first guess. Of a bent map, the part
 *  that fits best is laid down. Swapping the maps gives the inverse pose and the same numbers; a
 *  map fits itself as it is. Maps without walls have no candidates and confidence 0.
 *  Deterministic. About 0.1 s for two maps of 1000 m2. */
Alignment alignMaps(const WallMap& a, const WallMap& b, const SearchEffort& effort = kFullSearch);

/** The same, but looks only near `poses` (a <- b), so that what lies elsewhere is not known: the
 *  confidence is for the case that it must be one of these. A few ms for each. */
Alignment alignMapsNear(const WallMap& a, const WallMap& b, const std::vector<Transform2D>& poses);

}  // namespace roomgraph
