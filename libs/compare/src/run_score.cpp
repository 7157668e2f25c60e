#include "roomgraph/compare/run_score.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

void grade(RunScore& score, const MapError& error, const CompareRunsOptions& options) {
  const auto at = [&](double e) { return 100 * std::exp(-e / options.scoreScale); };
  score.mapError = error.error, score.errorLow = error.low, score.errorHigh = error.high;
  score.confirmed = error.confirmed, score.contradicted = error.contradicted;
  score.givenUp = error.givenUp, score.jitter = error.jitter;
  score.scale = error.scale, score.isScaleDisputed = error.scaleSet != ScaleSet::one;
  score.score = at(error.error), score.low = at(error.high), score.high = at(error.low);
}

/** Falls with the error; runs that have little in common with any other are not asked. Of edits
 *  of one picture, one is. */
void setTrust(RunScores& scores, const PairBends& bends, const DistinctMaps& maps,
              const CompareRunsOptions& options) {
  const auto isSmall = [&](std::size_t i) { return mostShare(bends, i) < options.leastShare; };
  bool areAllSmall = true;
  for (std::size_t i = 0; i < scores.size(); ++i) areAllSmall = areAllSmall && isSmall(i);
  double most = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i] || (isSmall(i) && !areAllSmall)) continue;
    if (maps.count() > 1 && !maps.isVoice(i)) continue;
    // What others contradict may lie anywhere: its word, as on rooms, is that of the worst case.
    const double error = scores[i]->contradicted > 0 ? scores[i]->errorHigh : scores[i]->mapError;
    scores[i]->trust = std::pow(kTrustFloor + error, -4);
    most = std::max(most, scores[i]->trust);
  }
  for (auto& score : scores)
    if (score && most > 0) score->trust /= most;
}

/** Sets what of one run was compared with the others, as their trust weighs it. Returns the share
 *  of all others but one, that of which it was most. */
double weigh(RunScores& scores, std::size_t run, const PairBends& bends, const DistinctMaps& maps,
             std::optional<std::size_t> reference) {
  const auto isAsked = [&](std::size_t other) {
    return reference ? other == *reference : maps.isMeasuredAgainst(run, other);
  };
  RunScore& score = *scores[run];
  double weights = 0, trust = 0, shares = 0, most = 0;
  for (const std::size_t j : bends.othersOf(run)) {
    if (!isAsked(j) || bends(run, j).share <= 0) continue;
    const PairBend& pair = bends(run, j);
    const double trustOfOther = scores[j] ? scores[j]->trust : double(j == reference);
    weights += trustOfOther * pair.share, trust += trustOfOther;
    score.support += pair.walls;
    ++score.others;
    shares += pair.share, most = std::max(most, pair.share);
  }
  if (weights > 0) score.share = weights / trust;
  return shares - most;
}

/** What contradicts a run, and cannot be told itself, does not show which of them errs. */
void doubtIfOnlyDoubtfulContradict(RunScores& scores, const DistinctMaps& maps) {
  std::set<std::size_t> told;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (scores[i] && scores[i]->isMeaningful) told.insert(maps.voiceOf(i));
  if (told.size() != 1) return;
  for (auto& score : scores)
    if (score && score->contradicted > 0) score->isMeaningful = false;
}

}  // namespace

RunScores scoreRuns(const PairBends& bends, const DistinctMaps& maps,
                    const std::vector<MapError>& errors, std::optional<std::size_t> reference,
                    const CompareRunsOptions& options) {
  if (reference && *reference >= bends.things())
    throw UsageError("run_score: there is no run " + std::to_string(*reference));
  if (errors.size() != bends.things())
    throw UsageError("run_score: there are " + std::to_string(bends.things()) + " runs, but " +
                     std::to_string(errors.size()) + " errors");
  RunScores scores(bends.things());
  for (std::size_t i = 0; i < bends.things(); ++i) {
    if (i == reference || errors[i].seen <= 0) continue;
    scores[i].emplace();
    grade(*scores[i], errors[i], options);
  }
  setTrust(scores, bends, maps, options);
  const bool haveWitness = reference || maps.count() > 1;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i]) continue;
    const double shareOfSecond = weigh(scores, i, bends, maps, reference);
    RunScore& score = *scores[i];
    // One other alone, or one and a scan or two, cannot tell which of the two errs.
    const double least = std::min(mostShare(bends, i), reference ? 1 : shareOfSecond);
    score.isMeaningful = haveWitness && score.support >= kFewestWalls &&
                         least >= options.leastShare && score.others >= 1 &&
                         score.confirmed >= kMajority && score.fitsReference();
  }
  if (!reference) doubtIfOnlyDoubtfulContradict(scores, maps);
  return scores;
}

Trust trustOf(const RunScores& scores, std::optional<std::size_t> reference) {
  if (!reference) return witnessesOf(scores, {});
  Trust trust(scores.size());
  trust[*reference] = 1;
  return trust;
}

Trust witnessesOf(const RunScores& scores, std::optional<std::size_t> reference) {
  Trust trust;
  for (std::size_t i = 0; i < scores.size(); ++i)
    trust.push_back(i == reference ? 1 : scores[i] ? scores[i]->trust : 0);
  return trust;
}

std::string unconfirmedFault(double confirmed, double contradicted, double coverage) {
  if (contradicted > 0)
    return formatted("has drawn %.0f %% that others contradict, and that fits nowhere else",
                     std::max(1.0, 100 * contradicted));
  if (confirmed - std::min(1 - confirmed, 1 - coverage) >= kNearlyAll) return "";
  if (confirmed < kNearlyAll)
    return formatted("is confirmed by others in %.0f %% of what it has drawn, less than %.0f %%",
                     std::floor(100 * confirmed), 100 * kNearlyAll);
  return formatted(
      "has drawn %.0f %% that no other run confirms, and lacks %.0f %% of what others have: a part "
      "may lie in a wrong place",
      100 * (1 - confirmed), 100 * (1 - coverage));
}

}  // namespace roomgraph
