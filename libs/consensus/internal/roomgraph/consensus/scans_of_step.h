#pragma once
#include <vector>

#include "roomgraph/align/find_scan.h"
#include "roomgraph/consensus/gait.h"

namespace roomgraph {

// In:   the scans of a run, and where the run has drawn them
// Out:  WallMap, LocalScan
// Next: mendSteps, StepWitness

constexpr PoseTolerance kAsDrawn{0.05, 0.2};  ///< what scans are usually off by

/** The fit of a scan near where it was drawn, or as it was drawn where that leads elsewhere. */
ScanFit asDrawn(const LocalScan& scan, const WallMap& in, const Transform2D& drawn);

/** The few scans nearest to a step as one: those before it in the map, those behind it seen from
 *  the first of them. */
struct StepView {
  LocalScan before, after;
};

/** What the scans on either side of a step of a run see, as maps and as one scan. Keeps references
 *  to the scans and to where they were drawn. */
class ScansOfStep {
 public:
  /** Of the walls those count that are not far from their scan, by its `gait`. */
  ScansOfStep(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
              const Gait& gait)
      : scans_(scans), drawn_(drawn), range_(10 + 2 * gait.longest.place) {}

  Transform2D step(std::size_t from, std::size_t to) const {
    return drawn_[from].inverse() * drawn_[to];
  }

  /** What the few before the step to `k` have drawn, at `poses`; without a wall if nothing. */
  WallMap ahead(std::size_t k, const std::vector<Transform2D>& poses) const;

  /** What was drawn about the robot at any time before: it may turn to what only that shows. */
  WallMap around(std::size_t k, const std::vector<Transform2D>& poses) const;

  /** What those behind the step to `k` have drawn, seen from the first of them. */
  const WallMap& behind(std::size_t k);

  StepView view(std::size_t k, const std::vector<Transform2D>& poses) const;

  /** A fit of those behind the step in what those before it have drawn, by the walls of both. */
  ScanFit weighed(std::size_t k, const StepView& view, ScanFit fit);

  static constexpr std::size_t kTogether = 3;  ///< scans that are looked for as one, or in one map

 private:
  LocalScan together(std::size_t first, std::size_t end,
                     const std::vector<Transform2D>& poses) const;
  std::vector<Transform2D> posesFrom(std::size_t k) const;
  std::size_t endBehind(std::size_t k) const;

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& drawn_;
  double range_;
  WallMap behind_;
  std::size_t behindOf_ = 0;  // the first scan in that map; 0 before there is one
};

}  // namespace roomgraph
