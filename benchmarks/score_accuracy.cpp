// How well the scores of simulated runs agree with the true errors of these runs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "Random.h"
#include "run_benchmark.h"
#include "simulated_site.h"
#include "spearman.h"

namespace roomgraph {
namespace {

/** What one comparison is worth, each from 0 to 1 but the first. */
struct Accuracy {
  double spearman = 0;  ///< of the estimated with the true errors
  double named = 0;     ///< the first is the best, or within 10 % + 2 cm of it
  double near = 0;      ///< share of the estimates within a factor of 1.5, or 3 cm
  double held = 0;      ///< share of the true errors that the interval holds
  double sound = 0;     ///< no nearly perfect run ranks below a broken one
  double alike = 0;     ///< the intervals of runs that differ in seed alone overlap

  void add(const Accuracy& other, double weight) {
    spearman += weight * other.spearman, named += weight * other.named;
    near += weight * other.near, held += weight * other.held;
    sound += weight * other.sound, alike += weight * other.alike;
  }
};

bool isNear(double estimate, double truth) {
  return std::abs(estimate - truth) <= 0.03 || (estimate <= 1.5 * truth && truth <= 1.5 * estimate);
}

constexpr double kNearlyPerfect = 0.1;  // an error up to which a run is that [m]

/** A run as it was scored, and as it is. */
struct Scored {
  RunScore score;
  double truth;
  bool isBroken;
  std::string settings;
};

bool areInOrder(const std::vector<Scored>& runs) {
  for (const Scored& l : runs)
    for (const Scored& r : runs)
      if (!l.isBroken && l.truth <= kNearlyPerfect && r.isBroken &&
          l.score.mapError > r.score.mapError)
        return false;
  return true;
}

bool areRepeatsAlike(const std::vector<Scored>& runs) {
  for (const Scored& l : runs)
    for (const Scored& r : runs)
      if (l.settings == r.settings && l.score.errorLow > r.score.errorHigh) return false;
  return true;
}

/** Runs that are left out count as wrong in `near` and `held`. */
Accuracy accuracyOf(const Comparison& found, const SimulatedSite& site,
                    const std::vector<std::size_t>& drawn) {
  std::vector<double> estimates, truths;
  std::vector<Scored> scored;
  double least = HUGE_VAL;
  Accuracy accuracy;
  for (const std::size_t i : drawn) {
    least = std::min(least, site.truth[i]);
    for (const ComparedRun& run : found.runs) {
      if (run.name != site.runs[i].name || !run.score) continue;
      const double truth = site.truth[i];
      estimates.push_back(run.score->mapError), truths.push_back(truth);
      scored.push_back({*run.score, truth, site.breaks[i].has_value(), site.settings[i]});
      accuracy.near += isNear(run.score->mapError, truth) / double(drawn.size());
      accuracy.held +=
          (run.score->errorLow <= truth && truth <= run.score->errorHigh) / double(drawn.size());
    }
  }
  accuracy.sound = areInOrder(scored), accuracy.alike = areRepeatsAlike(scored);
  if (estimates.empty()) return accuracy;
  const auto first = std::min_element(estimates.begin(), estimates.end()) - estimates.begin();
  accuracy.named = truths[std::size_t(first)] <= 1.1 * least + 0.02;
  accuracy.spearman = spearman(estimates, truths);
  return accuracy;
}

Accuracy compareDrawn(const SimulatedSite& site, const std::vector<std::size_t>& drawn) {
  std::vector<Run> runs;
  for (const std::size_t i : drawn) runs.push_back(site.runs[i]);
  MapPairs related(drawn.size());
  for (const auto& [a, b] : related.pairs()) related(a, b) = site.related(drawn[a], drawn[b]);
  return accuracyOf(compareRuns(runs, related, {}), site, drawn);
}

/** `size` of `all` numbers, ascending. */
std::vector<std::size_t> draw(std::size_t all, std::size_t size, Random& random) {
  std::vector<std::size_t> numbers(all);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t i = 0; i < size; ++i)
    std::swap(numbers[i], numbers[i + std::size_t(random.below(int(all - i)))]);
  numbers.resize(size);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

void measureSite(const SimulatedSite& site, int draws) {
  for (const std::size_t size : {site.runs.size(), std::size_t(5), std::size_t(3)}) {
    const int count = size == site.runs.size() ? 1 : draws;
    Random random(1);
    Accuracy mean;
    for (int k = 0; k < count; ++k)
      mean.add(compareDrawn(site, draw(site.runs.size(), size, random)), 1.0 / count);
    if (count == 0) continue;
    std::printf("| %s | %zu | %d | %.3f | %.0f %% | %.0f %% | %.0f %% | %.1f %% | %.1f %% |\n",
                site.name.c_str(), size, count, mean.spearman, 100 * mean.named, 100 * mean.near,
                100 * mean.held, 100 * mean.sound, 100 * mean.alike);
    std::fflush(stdout);
  }
}

void measure(const std::string& data, const std::string& only, const std::string& extension,
             int draws) {
  const std::vector<std::string> folders = simulatedSites(data, only);
  std::printf(
      "| site | runs | draws | Spearman | best named | within 1.5 or 3 cm | in interval | nearly "
      "perfect before broken | repeats overlap |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& folder : folders) measureSite(readSite(folder, extension), draws);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("How well the scores of simulated runs agree with the true errors.");
  std::string data, only, extension = ".gridmap.gz";
  int draws = 200;
  roomgraph::declareSites(data, only, app);
  app.add_option("--extension", extension, "of the runs")->capture_default_str();
  app.add_option("--draws", draws, "of five and of three runs a site")->capture_default_str();
  return roomgraph::runBenchmark(app, argc, argv,
                                 [&] { roomgraph::measure(data, only, extension, draws); });
}
