#include "sample_runs.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

constexpr double kDegree = M_PI / 180;

/** How the tour of the office is changed. */
struct Way {
  std::size_t start = 0;  ///< corner to begin with
  bool isReversed = false;
  std::size_t skipFrom = 0, skipTo = 0;  ///< corners that are left out, up to without the last
};

struct RunPlan {
  const char* name;
  Way way;
  double turn;  ///< of the run's frame in that of the office [rad]
  DriftOptions drift;
};

std::vector<RunPlan> plans() {
  return {{"office_run1", {0, false, 0, 0}, 0, {0, 0.0003, {}, 0, 1}},
          {"office_run2", {29, true, 0, 0}, 0.8, {0.0003, 0.0008, {}, 0, 2}},
          {"office_run3", {54, false, 8, 13}, -2.5, {0.0012, 0.002, {}, 0, 3}},
          {"office_run4", {66, true, 0, 0}, 2.2, {0, 0.0003, 60, 4 * kDegree, 4}}};
}

/** The tour is closed: its last corner is its first. */
std::vector<Point> changed(std::vector<Point> tour, const Way& way) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
    const std::size_t at = (way.start + i) % (tour.size() - 1);
    if (at < way.skipFrom || at >= way.skipTo) corners.push_back(tour[at]);
  }
  corners.push_back(corners.front());
  if (way.isReversed) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace

std::vector<SampleRun> sampleRuns(const SampleOffice& office) {
  constexpr int keyframes = 120;
  std::vector<SampleRun> runs;
  for (const RunPlan& plan : plans()) {
    SampleRun run;
    run.name = plan.name;
    run.truth = walk(changed(office.tour, plan.way), keyframes);
    run.believed = drift(run.truth, {0, 0, run.truth.front().heading - plan.turn}, plan.drift);
    run.breakAt = plan.drift.breakAt;
    run.breakTurn = plan.drift.breakTurn;
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace roomgraph
