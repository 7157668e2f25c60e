// How well the breaks that simulated runs were given are found.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "run_benchmark.h"
#include "simulated_site.h"

namespace roomgraph {
namespace {

constexpr double kPlace = 2, kAngle = 1, kShift = 0.25;  // that count as found [m, deg, m]

double degrees(double angle) { return angle * 180 / M_PI; }

/** True frame <- site, by the run with the least error. */
Transform2D siteToTruth(const Comparison& found, const SimulatedSite& site) {
  const auto best =
      std::size_t(std::min_element(site.truth.begin(), site.truth.end()) - site.truth.begin());
  for (const ComparedRun& run : found.runs)
    if (run.name == site.runs[best].name) return site.toTruth[best] * run.pose.inverse();
  return {};
}

bool isFound(const MapBreak& found, const MapBreak& given, const Transform2D& toTruth) {
  // Grids tell only which of two fragments is the smaller one, not which was drawn first.
  const double turn = found.keyFrame ? found.rotation - given.rotation
                                     : std::abs(found.rotation) - std::abs(given.rotation);
  return distance(toTruth(found.place), given.place) <= kPlace &&
         std::abs(degrees(turn)) <= kAngle && std::abs(found.shift - given.shift) <= kShift;
}

void printBreak(const std::string& site, const MapBreak& found,
                const std::optional<MapBreak>& given, const Transform2D& toTruth) {
  std::printf("| %s %s | %.1f | %.2f |", site.c_str(), found.run.c_str(), degrees(found.rotation),
              found.shift);
  if (given)
    std::printf(" %.1f | %.2f | %.2f | %s |\n", degrees(given->rotation), given->shift,
                distance(toTruth(found.place), given->place),
                isFound(found, *given, toTruth) ? "found" : "another one");
  else
    std::printf(" | | | none was given |\n");
}

void measure(const std::string& data, const std::string& only, const std::string& extension) {
  int given = 0, found = 0, unbroken = 0, quiet = 0;
  std::printf(
      "| run | turn found [deg] | shift found [m] | turn given | shift given | apart [m] | |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const std::string& folder : simulatedSites(data, only)) {
    const SimulatedSite site = readSite(folder, extension);
    const Comparison comparison = compareRuns(site.runs, site.related, {});
    const Transform2D toTruth = siteToTruth(comparison, site);
    for (std::size_t i = 0; i < site.runs.size(); ++i) {
      bool isRight = false, isAny = false;
      for (const MapBreak& one : comparison.breaks) {
        if (one.run != site.runs[i].name) continue;
        printBreak(site.name, one, site.breaks[i], toTruth);
        isAny = true;
        isRight = isRight || (site.breaks[i] && isFound(one, *site.breaks[i], toTruth));
      }
      site.breaks[i] ? ++given : ++unbroken;
      found += isRight, quiet += !site.breaks[i] && !isAny;
    }
    std::fflush(stdout);
  }
  std::printf("\n%d of %d breaks found; %d of %d runs without a break show none.\n", found, given,
              quiet, unbroken);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("How well the breaks that simulated runs were given are found.");
  std::string data, only, extension = ".simplemap.gz";
  roomgraph::declareSites(data, only, app);
  app.add_option("--extension", extension, "of the runs")->capture_default_str();
  return roomgraph::runBenchmark(app, argc, argv,
                                 [&] { roomgraph::measure(data, only, extension); });
}
