// How well the scale of a floor plan is found by the runs of its building.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/relate/estimate_scale.h"
#include "run_benchmark.h"
#include "simulated_site.h"

namespace roomgraph {
namespace {

/** A site, and its true plan. */
struct PlannedSite {
  SimulatedSite site;
  Grid plan;
};

/** Which runs tell the scale. */
struct Tellers {
  std::string name;
  std::vector<Run> runs;
};

/** All runs; the half with the least errors; the three with the largest. */
std::vector<Tellers> tellersOf(const SimulatedSite& site) {
  std::vector<std::size_t> order(site.runs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t l, std::size_t r) { return site.truth[l] < site.truth[r]; });
  Tellers good{"better half", {}}, bad{"worst three", {}};
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k < order.size() / 2) good.runs.push_back(site.runs[order[k]]);
    if (k + 3 >= order.size()) bad.runs.push_back(site.runs[order[k]]);
  }
  sortRuns(good.runs), sortRuns(bad.runs);
  return {{"all", site.runs}, good, bad};
}

/** Prints a row; the error as a share, none where no scale was found. */
std::optional<double> estimate(const PlannedSite& of, const Tellers& tellers, double guess) {
  const double truth = of.plan.frame.resolution;
  const auto found = estimateScale(rescaled(of.plan, guess * truth), tellers.runs, oneByOne);
  std::printf("| %s | %s | %.3f | ", of.site.name.c_str(), tellers.name.c_str(), guess * truth);
  if (!found) {
    std::printf("none | | |\n");
  } else {
    std::printf("%.5f | %+.2f %% | %zu |\n", found->resolution,
                100 * (found->resolution / truth - 1), found->runs);
  }
  std::fflush(stdout);
  return found ? std::optional(found->resolution / truth - 1) : std::nullopt;
}

void estimateOwn(const std::vector<PlannedSite>& sites) {
  std::printf(
      "| plan | told by runs | first guess [m] | found [m] | error | runs that say so |\n"
      "|---|---|---|---|---|---|\n");
  int asked = 0, found = 0, near = 0;
  for (const PlannedSite& one : sites)
    for (const Tellers& tellers : tellersOf(one.site))
      for (const double guess : {0.5, 1.0, 2.2}) {
        if (tellers.name != "all" && guess != 1) continue;
        const auto error = estimate(one, tellers, guess);
        ++asked, found += error.has_value(), near += error && std::abs(*error) <= 0.01;
      }
  std::printf("\n%d of %d scales found, %d of them within 1 %%.\n", found, asked, near);
}

void refuseOthers(const std::vector<PlannedSite>& sites) {
  int asked = 0, refused = 0;
  for (const PlannedSite& plan : sites)
    for (const PlannedSite& other : sites) {
      if (&plan == &other) continue;
      const auto found = estimateScale(plan.plan, other.site.runs, oneByOne);
      ++asked, refused += !found;
      if (found)
        std::printf("\n%s was taken for %s, at %.4f m.\n", plan.site.name.c_str(),
                    other.site.name.c_str(), found->resolution);
    }
  std::printf("\n%d of %d plans of other buildings refused.\n", refused, asked);
}

void measure(const std::string& data, const std::string& only) {
  std::vector<PlannedSite> sites;
  const ExtractOptions options;
  for (const std::string& folder : simulatedSites(data, only)) {
    const GreyMap map = loadGrid(folder + "/truth.gridmap.gz", options.loadGrid);
    sites.push_back({readSite(folder, ".gridmap.gz"), binarize(map, options.binarize)});
  }
  estimateOwn(sites);
  refuseOthers(sites);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("How well the scale of a floor plan is found by the runs of its building.");
  std::string data, only;
  roomgraph::declareSites(data, only, app);
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::measure(data, only); });
}
