#include "roomgraph/align/alignment_confidence.h"

#include <algorithm>
#include <cmath>

#include "fitted_align.h"

namespace roomgraph {
namespace {

/** Shares of what was looked at, each with a few metres of prior so that little evidence says
 *  little. */
struct Shares {
  double onWall, slightly, deep, found;

  explicit Shares(const AlignmentEvidence& e)
      : onWall((e.freeOnWall * e.common + 0.3) / (e.common + 10)),
        slightly((e.slightly + 1) / (e.known + 10)),
        deep((e.contradicted + 0.5) / (e.known + 10)),
        found((e.loose + e.close) / (e.known + 10)) {}
};

}  // namespace

double alignmentScore(const AlignmentEvidence& e) {
  const Shares share(e);
  const auto& w = fitted::kScore;
  return w[0] * std::log1p(e.loose) + w[1] * std::log1p(std::max(0.0, e.weakest)) +
         w[2] * std::sqrt(1 + e.loose) + w[3] * share.found + w[4] * std::log(share.onWall) +
         w[5] * std::log(share.slightly) + w[6] * std::log(share.deep);
}

double sameSiteLogOdds(const AlignmentEvidence& e) {
  const Shares share(e);
  const auto& w = fitted::kSameSite;
  const double odds = w[0] + w[1] * std::log1p(e.loose) + w[2] * std::log(share.onWall) +
                      w[3] * std::log(share.slightly) + w[4] * std::log(share.deep) +
                      w[5] * share.found + w[6] * std::log1p(std::max(0.0, e.weakest)) +
                      w[7] * std::log(e.overlap + 0.05) +
                      w[8] * std::log((e.known + 1) / (e.all + 1)) +
                      w[9] * e.contradicted / (e.known + 10) + w[10] * e.slightly / (e.known + 10);
  return std::clamp(odds, -6.0, 6.0);
}

double poseConfidence(double bestLogOdds, double runnerUpLogOdds, double scoreMargin,
                      double weakest) {
  const double margin = std::clamp(scoreMargin, 0.0, 6.0);
  const double rival = std::clamp(runnerUpLogOdds, -4.0, 3.0);
  const auto& w = fitted::kRightPose;
  const double odds = w[0] + w[1] * bestLogOdds + w[2] * margin + w[3] * rival +
                      w[4] * margin * probability(rival - 1);
  const double confidence = probability(odds);
  if (isAmbiguousPose(runnerUpLogOdds, scoreMargin) || weakest < fitted::kHeld)
    return std::min(confidence, fitted::kAmbiguousConfidence);
  const bool hasRival =
      runnerUpLogOdds > fitted::kAmbiguousOdds && scoreMargin < fitted::kRivalMargin;
  return hasRival ? std::min(confidence, kSureConfidence) : confidence;
}

bool isAmbiguousPose(double runnerUpLogOdds, double scoreMargin) {
  return runnerUpLogOdds > fitted::kAmbiguousOdds && scoreMargin < fitted::kAmbiguousMargin;
}

double probability(double logOdds) { return 1 / (1 + std::exp(-logOdds)); }

}  // namespace roomgraph
