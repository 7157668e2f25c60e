#include "roomgraph/compare/run_score.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

using Distances = std::vector<std::vector<PairDistance>>;

constexpr double kConverged = 1e-9;
constexpr double kNothingShared = 1;  // distance of a run that shares no walls, so none trusts it
constexpr double kEightyPercent = 1.2816;  // standard deviations either way that hold 80 %

double weightOf(const PairDistance& pair, double trust, const RunScoreOptions& options) {
  return trust * std::min(1.0, pair.count / options.fullCount);
}

/** The trusted mean of a run's distances, without run `but`. */
double consensus(const Distances& d, const std::vector<double>& trust, std::size_t run,
                 std::size_t but, const RunScoreOptions& options) {
  double sum = 0, weights = 0;
  for (std::size_t j = 0; j < d.size(); ++j) {
    if (j == run || j == but) continue;
    const double w = weightOf(d[run][j], trust[j], options);
    sum += w * d[run][j].mean;
    weights += w;
  }
  return weights > 0 ? sum / weights : kNothingShared;
}

double medianDistance(const Distances& d, std::size_t run) {
  std::vector<double> all;
  for (std::size_t j = 0; j < d.size(); ++j)
    if (j != run && d[run][j].count > 0) all.push_back(d[run][j].mean);
  if (all.empty()) return kNothingShared;
  std::sort(all.begin(), all.end());
  return 0.5 * (all[(all.size() - 1) / 2] + all[all.size() / 2]);
}

std::vector<double> trustAt(const std::vector<double>& distance, const RunScoreOptions& options) {
  std::vector<double> trust;
  for (const double c : distance) trust.push_back(std::pow(options.trustFloor + c, -4));
  const double most = trust.empty() ? 1 : *std::max_element(trust.begin(), trust.end());
  for (double& t : trust) t /= most;
  return trust;
}

std::vector<double> trustOfAll(const Distances& d, const RunScoreOptions& options) {
  std::vector<double> at(d.size());
  for (std::size_t i = 0; i < d.size(); ++i) at[i] = medianDistance(d, i);
  for (int k = 0; k < options.iterations; ++k) {
    const std::vector<double> trust = trustAt(at, options);
    double moved = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      // Half a step at a time, as full ones can swing to and fro.
      const double next = 0.5 * (at[i] + consensus(d, trust, i, i, options));
      moved = std::max(moved, std::abs(next - at[i]));
      at[i] = next;
    }
    if (moved < kConverged) break;
  }
  return trustAt(at, options);
}

/** Jackknife standard error of a run's consensus distance over the other runs. */
double standardError(const Distances& d, const std::vector<double>& trust, std::size_t run,
                     const RunScoreOptions& options) {
  std::vector<double> without;
  for (std::size_t j = 0; j < d.size(); ++j)
    if (j != run && weightOf(d[run][j], trust[j], options) > 0)
      without.push_back(consensus(d, trust, run, j, options));
  const double n = double(without.size());
  if (n < 2) return 0;
  double mean = 0, squares = 0;
  for (const double c : without) mean += c / n;
  for (const double c : without) squares += (c - mean) * (c - mean);
  return std::sqrt((n - 1) / n * squares);
}

void grade(RunScore& score, double error, const RunScoreOptions& options) {
  const auto at = [&](double e) { return 100 * std::exp(-e / options.scoreScale); };
  score.mapError = mapErrorAt(score.distance, options);
  const double by = kEightyPercent * error;
  const double small = options.smallError;
  const double low = mapErrorAt(score.distance - by, options) + small;
  const double high = mapErrorAt(score.distance + by, options) + small;
  score.errorLow = std::max(0.0, low / options.spread - small);
  score.errorHigh = high * options.spread - small;
  score.score = at(score.mapError);
  score.low = at(score.errorHigh), score.high = at(score.errorLow);
}

}  // namespace

double mapErrorAt(double distance, const RunScoreOptions& options) {
  return options.scale * std::pow(std::max(0.0, distance - options.noise), options.power);
}

std::vector<std::optional<RunScore>> scoreRuns(const Distances& distances,
                                               std::optional<std::size_t> reference,
                                               const RunScoreOptions& options) {
  if (reference && *reference >= distances.size())
    throw UsageError("run_score: there is no run " + std::to_string(*reference));
  std::vector<double> trust(distances.size(), 0);
  if (reference)
    trust[*reference] = 1;
  else
    trust = trustOfAll(distances, options);
  std::vector<std::optional<RunScore>> scores(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (i == reference) continue;
    RunScore score;
    score.trust = trust[i];
    for (std::size_t j = 0; j < distances.size(); ++j) {
      if (j == i || weightOf(distances[i][j], trust[j], options) <= 0) continue;
      score.support += distances[i][j].count;
      ++score.others;
    }
    if (score.others == 0) continue;
    score.distance = consensus(distances, trust, i, i, options);
    grade(score, standardError(distances, trust, i, options), options);
    score.isMeaningful =
        score.support >= options.minCount && score.others >= (reference ? 1 : options.minOthers);
    scores[i] = score;
  }
  return scores;
}

}  // namespace roomgraph
