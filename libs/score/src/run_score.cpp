#include "roomgraph/score/run_score.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "most_share.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/relate/DistinctMaps.h"

namespace roomgraph {
namespace {

using Bends = std::vector<std::vector<PairBend>>;
using Errors = std::vector<std::optional<MapError>>;

/** Estimates the errors with one run for all that have the same map. */
Errors errorsOfAll(const Bends& bends, const std::vector<OwnEvidence>& own,
                   std::optional<std::size_t> reference, const MapErrorOptions& options) {
  const DistinctMaps maps(bends);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < bends.size(); ++i)
    if (maps.isFirst(i)) kept.push_back(i);
  Bends some(kept.size(), std::vector<PairBend>(kept.size()));
  std::vector<std::optional<double>> told;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    told.push_back(own[kept[i]].axisDeviation);
    for (std::size_t j = 0; j < kept.size(); ++j) some[i][j] = bends[kept[i]][kept[j]];
  }
  const auto placeOf = [&](std::size_t i) {
    const auto place = std::lower_bound(kept.begin(), kept.end(), maps.firstOf(i));
    return std::size_t(place - kept.begin());
  };
  std::optional<std::size_t> truth;
  if (reference) truth = placeOf(*reference);
  const Errors found = estimateMapErrors(some, told, truth, options);
  Errors errors(bends.size());
  for (std::size_t i = 0; i < bends.size(); ++i) {
    errors[i] = found[placeOf(i)];
    const bool isCopyOfAll = kept.size() == 1 && bends.size() > 1;
    if (isCopyOfAll || truth == placeOf(i)) errors[i] = MapError{};
    if (i == reference) errors[i].reset();
  }
  return errors;
}

void grade(RunScore& score, const MapError& error, const RunScoreOptions& options) {
  const auto at = [&](double e) { return 100 * std::exp(-e / options.scoreScale); };
  score.mapError = error.error, score.errorLow = error.low, score.errorHigh = error.high;
  score.score = at(error.error), score.low = at(error.high), score.high = at(error.low);
}

/** Sets trust, then each run's bend away from the others as their trust weighs it. */
void weigh(std::vector<std::optional<RunScore>>& scores, const Bends& bends,
           std::optional<std::size_t> reference, const RunScoreOptions& options) {
  const bool areAllSmall = std::none_of(bends.begin(), bends.end(), [&](const auto& row) {
    return mostShare(row) >= options.minShare;
  });
  double most = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i] || (mostShare(bends[i]) < options.minShare && !areAllSmall)) continue;
    scores[i]->trust = std::pow(options.trustFloor + scores[i]->mapError, -4);
    most = std::max(most, scores[i]->trust);
  }
  for (auto& score : scores)
    if (score && most > 0) score->trust /= most;
  const DistinctMaps maps(bends);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i]) continue;
    double sum = 0, weights = 0, found = 0, trust = 0;
    for (std::size_t j = 0; j < bends.size(); ++j) {
      if (bends[i][j].share <= 0 || (reference && j != reference)) continue;
      if (!reference && !maps.isMeasuredAgainst(i, j)) continue;
      const double weight = (scores[j] ? scores[j]->trust : 1) * bends[i][j].share;
      sum += weight * bends[i][j].bend, weights += weight;
      found += (scores[j] ? scores[j]->trust : 1) * bends[i][j].share;
      trust += scores[j] ? scores[j]->trust : 1;
      scores[i]->support += bends[i][j].walls;
      ++scores[i]->others;
    }
    if (weights > 0) scores[i]->bend = sum / weights, scores[i]->share = found / trust;
  }
}

}  // namespace

std::vector<std::optional<RunScore>> scoreRuns(const Bends& bends,
                                               const std::vector<OwnEvidence>& own,
                                               std::optional<std::size_t> reference,
                                               const RunScoreOptions& options) {
  if (reference && *reference >= bends.size())
    throw UsageError("run_score: there is no run " + std::to_string(*reference));
  const Errors errors = errorsOfAll(bends, own, reference, options.error);
  std::vector<std::optional<RunScore>> scores(bends.size());
  for (std::size_t i = 0; i < bends.size(); ++i) {
    if (!errors[i]) continue;
    scores[i].emplace();
    MapError error = *errors[i];
    error.low = std::max(0.0, error.low - own[i].noiseFloor), error.high += own[i].noiseFloor;
    grade(*scores[i], error, options);
  }
  weigh(scores, bends, reference, options);
  const std::size_t minOthers = reference ? 1 : options.minOthers;
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (auto& score = scores[i])
      score->isMeaningful = score->support >= options.minWalls && score->others >= minOthers &&
                            mostShare(bends[i]) >= options.minShare;
  return scores;
}

}  // namespace roomgraph
