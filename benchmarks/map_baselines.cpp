// How well other figures than the score agree with the true errors of runs.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "map_metrics.h"
#include "roomgraph/map_files/load_grid.h"
#include "run_benchmark.h"
#include "simulated_site.h"
#include "spearman.h"

namespace roomgraph {
namespace {

constexpr std::array<const char*, 6> kNames{"map error, ours", "MME",          "MPV", "MOM",
                                            "deviation",       "wall distance"};
using Figures = std::array<double, kNames.size()>;

std::vector<Point> scanPoints(const std::string& file) {
  std::vector<Point> points;
  for (const Keyframe& frame : loadMap(file, {}).keyframes)
    for (const Point end : frame.ends) points.push_back(frame.pose(end));
  return points;
}

/** Those of a run; what it has not is worse than all others. */
Figures figuresOf(const Run& run, const Comparison& found, const MapMetricsOptions& options) {
  const MapMetrics metrics = mapMetrics(scanPoints(run.file), options);
  Figures figures{HUGE_VAL,
                  metrics.entropy,
                  metrics.variance,
                  metrics.orthogonal,
                  run.map.axisDeviation.value_or(HUGE_VAL),
                  HUGE_VAL};
  for (const ComparedRun& compared : found.runs) {
    if (compared.name != run.name) continue;
    if (compared.score) figures[0] = compared.score->mapError;
    const Measure* distance = find(compared.measures, "wall_distance");
    if (distance && distance->value) figures[5] = *distance->value;
  }
  return figures;
}

/** Spearman of each figure with the truth, all runs of a site. */
Figures agreementOf(const SimulatedSite& site, const MapMetricsOptions& options) {
  const Comparison found = compareRuns(site.runs, site.related, {});
  std::array<std::vector<double>, kNames.size()> columns;
  for (const Run& run : site.runs) {
    const Figures figures = figuresOf(run, found, options);
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(figures[k]);
  }
  Figures agreement{};
  for (std::size_t k = 0; k < columns.size(); ++k) agreement[k] = spearman(columns[k], site.truth);
  return agreement;
}

void print(const std::string& name, const Figures& figures) {
  std::printf("| %s |", name.c_str());
  for (const double figure : figures) std::printf(" %.3f |", figure);
  std::printf("\n");
  std::fflush(stdout);
}

void measure(const std::string& data, const std::string& only, const MapMetricsOptions& options) {
  std::printf("| site |");
  for (const char* name : kNames) std::printf(" %s |", name);
  std::printf("\n|---|");
  for (std::size_t k = 0; k < kNames.size(); ++k) std::printf("---|");
  std::printf("\n");
  const std::vector<std::string> folders = simulatedSites(data, only);
  Figures mean{}, worst;
  worst.fill(1);
  for (const std::string& folder : folders) {
    const SimulatedSite site = readSite(folder, ".simplemap.gz");
    const Figures agreement = agreementOf(site, options);
    for (std::size_t k = 0; k < mean.size(); ++k) {
      mean[k] += agreement[k] / double(folders.size());
      worst[k] = std::min(worst[k], agreement[k]);
    }
    print(site.name, agreement);
  }
  print("**mean**", mean);
  print("worst", worst);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("How well other figures than the score agree with the true errors of runs.");
  std::string data, only;
  roomgraph::MapMetricsOptions options;
  roomgraph::declareSites(data, only, app);
  app.add_option("--radius", options.radius, "of what lies round a scan point [m]")
      ->capture_default_str();
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::measure(data, only, options); });
}
