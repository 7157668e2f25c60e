#include "roomgraph/consensus/StepWitness.h"

#include "fitted_consensus.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {

StepWitness::StepWitness(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn)
    : scans_(scans),
      drawn_(drawn),
      gait_(drawn, mapped(scans, &LocalScan::time)),
      sides_(scans, drawn, gait_) {}

std::optional<StepWitness::Fits> StepWitness::fitsOf(std::size_t k, const Transform2D& step) {
  const WallMap ahead = sides_.ahead(k, drawn_);
  if (ahead.walls.empty() || !scans_[k].isTelling()) return std::nullopt;
  const StepView view = sides_.view(k, drawn_);
  const auto fitAs = [&](const Transform2D& pose) {
    return sides_.weighed(k, view, asDrawn(view.after, ahead, pose));
  };
  return Fits{fitAs(drawn_[k]), fitAs(drawn_[k - 1] * step)};
}

bool StepWitness::refutes(std::size_t k, const Transform2D& step, RefutedBy by) {
  const auto fits = fitsOf(k, step);
  return fits && fits->drawn.quality >= kMajority &&
         (fits->drawn.score - fits->other.score > fitted::kClearSlip.leastGain ||
          (by == RefutedBy::wallsOrGait && !gait_.isLikely(step, k)));
}

bool StepWitness::prefers(std::size_t k, const Transform2D& step) {
  const auto fits = fitsOf(k, step);
  return fits && fits->other.score - fits->drawn.score > fitted::kSlip.leastGain;
}

}  // namespace roomgraph
