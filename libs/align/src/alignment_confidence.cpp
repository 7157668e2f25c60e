#include "roomgraph/align/alignment_confidence.h"

#include <algorithm>
#include <cmath>

#include "fitted_confidence.h"

namespace roomgraph {
namespace {

// Of the 48 answers that these two call ambiguous in the fitted pairs, 30 were right.
constexpr double kAmbiguousOdds = 2, kAmbiguousMargin = 2.5;
constexpr double kAmbiguousConfidence = 0.6;
// With a runner-up that could be the same site by itself, even if worse, no answer is sure.
constexpr double kRivalMargin = 4, kRivalConfidence = 0.9;
// One that slides is none: of the four sure answers held by less than 3 m of wall two were right;
// all others were held by 8 m or more.
constexpr double kHeld = 5;

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
  // Chosen by random search for the most pairs in which the right pose wins over all others.
  const Shares share(e);
  return 0.7 * std::log1p(e.loose) + 0.26 * std::log1p(std::max(0.0, e.weakest)) +
         0.17 * std::sqrt(1 + e.loose) + 0.2 * share.found - 2.0 * std::log(share.onWall) -
         0.45 * std::log(share.slightly) - 0.37 * std::log(share.deep);
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
  if (isAmbiguousPose(runnerUpLogOdds, scoreMargin) || weakest < kHeld)
    return std::min(confidence, kAmbiguousConfidence);
  const bool hasRival = runnerUpLogOdds > kAmbiguousOdds && scoreMargin < kRivalMargin;
  return hasRival ? std::min(confidence, kRivalConfidence) : confidence;
}

bool isAmbiguousPose(double runnerUpLogOdds, double scoreMargin) {
  return runnerUpLogOdds > kAmbiguousOdds && scoreMargin < kAmbiguousMargin;
}

double probability(double logOdds) { return 1 / (1 + std::exp(-logOdds)); }

}  // namespace roomgraph
