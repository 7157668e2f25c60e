// How well the areas of an extraction agree with floor plans whose rooms were labelled by hand.
//
// A plan's areas (rooms and pieces of corridor) are scored pixel by pixel against the truth, with
// the defaults for all plans. Where a picture has another size than its truth, its cells get the
// ratio of the widths as scale, and the truth is read at the nearest pixel of each cell's centre.
// Figures are means over the plans; a plan without areas counts as 0.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "cpu_seconds.h"
#include "floor_plans.h"
#include "room_rules.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/evaluation/score_rooms.h"
#include "roomgraph/pipeline/extract.h"
#include "run_benchmark.h"

namespace roomgraph {
namespace {

constexpr std::size_t kMeasures = 7;
constexpr std::array<const char*, kMeasures> kMeasureNames{
    "P micro", "P macro", "R micro", "R macro", "IoU seg", "IoU truth", "MCC"};
constexpr double kMostMilliseconds = 50;
constexpr int kTimedRuns = 3;

using Measures = std::array<double, kMeasures>;  ///< in percent, mcc from -1 to 1

/** A set of pictures of the same buildings. What has no target is 0. */
struct PlanSet {
  std::string option, title, variant;
  Measures target;
};

const std::array<PlanSet, 3> kSets{{
    {"plain", "Plain", "", {97, 95.5, 98, 95.5, 92, 90, 0.90}},
    {"furnished", "Furnished", "_furnitures", {94, 0, 92, 0, 85, 80, 0}},
    {"bins", "Furnished, with trash bins", "_furnitures_trashbins", {94, 0, 92, 0, 85, 80, 0}},
}};

struct PlanScore {
  std::string name;
  std::size_t areas = 0, truths = 0;  ///< those that count
  Measures measures{};
  double milliseconds = 0;  ///< of CPU
};

/** The truth as a picture of the map's size. */
LabelMap atCells(const LabelMap& truth, const GridFrame& frame) {
  if (truth.width == frame.width && truth.height == frame.height) return truth;
  LabelMap cells{frame.width, frame.height, std::vector<std::uint32_t>(frame.cellCount()),
                 truth.source};
  const auto nearest = [](int i, int of, int among) { return int((i + 0.5) * among / of); };
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x)
      cells.label[frame.index({x, y})] =
          truth.label[std::size_t(nearest(y, frame.height, truth.height)) *
                          std::size_t(truth.width) +
                      std::size_t(nearest(x, frame.width, truth.width))];
  return cells;
}

Measures measuresOf(const RoomScore& score) {
  return {100 * score.precisionMicro.value_or(0),
          100 * score.precisionMacro.value_or(0),
          100 * score.recallMicro.value_or(0),
          100 * score.recallMacro.value_or(0),
          100 * score.iouSeg.value_or(0),
          100 * score.iouTruth.value_or(0),
          score.mcc.value_or(0)};
}

PlanScore scorePlan(const GreyMap& map, const LabelMap& truth, const ExtractOptions& options,
                    int runs) {
  std::vector<double> seconds;
  Stages stages;
  for (int i = 0; i < runs; ++i) {
    const double start = cpuSeconds();
    stages = extract(map, options);
    seconds.push_back(cpuSeconds() - start);
  }
  std::sort(seconds.begin(), seconds.end());
  const auto& labels = stages.areas.labels;
  const LabelMap areas{map.frame.width, map.frame.height, {labels.begin(), labels.end()}, {}};
  const RoomScore score = scoreRooms(areas, atCells(truth, map.frame));
  return {"", score.seg.count, score.truth.count, measuresOf(score),
          1000 * seconds[seconds.size() / 2]};
}

/** Those of the named plans that have a picture in this set. */
std::vector<PlanScore> scoreSet(const std::string& data, const std::vector<std::string>& names,
                                const PlanSet& set, const ExtractOptions& options, int runs) {
  std::vector<PlanScore> scores;
  for (const std::string& name : names) {
    if (!hasFloorPlan(data, name, set.variant)) continue;
    const LabelMap truth = floorPlanTruth(data, name);
    const GreyMap map = floorPlan(data, name, set.variant, truth.width);
    scores.push_back(scorePlan(map, truth, options, runs));
    scores.back().name = name;
  }
  return scores;
}

Measures meanOf(const std::vector<PlanScore>& scores) {
  Measures mean{};
  for (const PlanScore& score : scores)
    for (std::size_t i = 0; i < kMeasures; ++i)
      mean[i] += score.measures[i] / double(scores.size());
  return mean;
}

const char* verdict(bool isReached) { return isReached ? "PASS" : "**missed**"; }

void printHeader(const char* first, const char* last) {
  std::printf("| %s |", first);
  for (const char* name : kMeasureNames) std::printf(" %s |", name);
  std::printf("%s\n|---|", last);
  for (std::size_t i = 0; i < kMeasures; ++i) std::printf("---|");
  std::printf("%s\n", *last ? "---|---|---|" : "");
}

void printMeasures(const std::string& name, const Measures& measures) {
  std::printf("| %s |", name.c_str());
  for (std::size_t i = 0; i + 1 < kMeasures; ++i) std::printf(" %.1f |", measures[i]);
  std::printf(" %.3f |", measures.back());
}

/** Prints the mean, the targets and whether they are reached; the time's is for the slowest. */
bool printVerdict(const std::vector<PlanScore>& scores, const PlanSet& set) {
  const Measures mean = meanOf(scores);
  double all = 0, slowest = 0, areas = 0, truths = 0;
  for (const PlanScore& score : scores) {
    all += score.milliseconds, slowest = std::max(slowest, score.milliseconds);
    areas += double(score.areas), truths += double(score.truths);
  }
  printMeasures("**mean**", mean);
  const double count = double(scores.size());
  std::printf(" %.1f | %.1f | %.1f |\n| target |", areas / count, truths / count, all / count);
  for (const double target : set.target)
    target > 0 ? std::printf(" >= %g |", target) : std::printf(" |");
  std::printf(" | | each <= %g |\n| |", kMostMilliseconds);
  bool isAllReached = slowest <= kMostMilliseconds;
  for (std::size_t i = 0; i < kMeasures; ++i) {
    const bool isReached = mean[i] >= set.target[i];
    set.target[i] > 0 ? std::printf(" %s |", verdict(isReached)) : std::printf(" |");
    isAllReached = isAllReached && (set.target[i] <= 0 || isReached);
  }
  std::printf(" | | %s |\n", verdict(slowest <= kMostMilliseconds));
  return isAllReached;
}

bool measureSet(const std::string& data, const std::vector<std::string>& names,
                const PlanSet& set) {
  const std::vector<PlanScore> scores =
      scoreSet(data, names, set, defaultRule().options, kTimedRuns);
  std::printf("%s (%zu):\n\n", set.title.c_str(), scores.size());
  if (scores.empty()) return true;
  printHeader("map", " areas | true areas | CPU [ms] |");
  for (const PlanScore& score : scores) {
    printMeasures(score.name, score.measures);
    std::printf(" %zu | %zu | %.1f |\n", score.areas, score.truths, score.milliseconds);
  }
  const bool isReached = printVerdict(scores, set);
  std::printf("\n");
  printHeader("rule, mean of these maps", "");
  for (const RoomRule& rule : ablatedRules()) {
    printMeasures(rule.name, meanOf(scoreSet(data, names, set, rule.options, 1)));
    std::printf("\n");
  }
  printMeasures(defaultRule().name, meanOf(scores));
  std::printf("\n\n");
  std::fflush(stdout);
  return isReached;
}

/** All plans, or the one named. */
std::vector<std::string> chosenPlans(const std::string& data, const std::string& only) {
  std::vector<std::string> names = floorPlanNames(data);
  if (only.empty()) return names;
  if (std::find(names.begin(), names.end(), only) != names.end()) return {only};
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  throw UsageError("there is no plan '" + only + "'; there are " + known);
}

bool measureAll(const std::string& data, const std::string& only, const std::string& onlySet) {
  const std::vector<std::string> names = chosenPlans(data, only);
  bool isAllReached = true;
  for (const PlanSet& set : kSets)
    if (onlySet.empty() || onlySet == set.option)
      isAllReached = measureSet(data, names, set) && isAllReached;
  return isAllReached;
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app(
      "Scores rooms and corridors against labelled floor plans; exit code 1 where a target is "
      "missed.");
  std::string data, only, onlySet;
  app.add_option("--data", data, "folder of the map data; it holds room_seg/ipa")->required();
  app.add_option("--map", only, "only this plan, as lab_a_scan");
  app.add_option("--set", onlySet, "only this set: plain, furnished or bins")
      ->check(CLI::IsMember({"plain", "furnished", "bins"}));
  return roomgraph::runBenchmark(app, argc, argv,
                                 [&] { return roomgraph::measureAll(data, only, onlySet); });
}
