// What the confidence of passages is worth: how many of those with about the same confidence, and
// with the same reason, are openings between two rooms of floor plans that were labelled by hand.
//
// A passage is true where most of what lies within a metre of its middle is another room of the
// truth in one of its areas than in the other. Doors that are not found do not count here.
#include <array>
#include <cstdio>
#include <map>
#include <string>

#include "floor_plans.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/rooms/reason_names.h"
#include "run_benchmark.h"

namespace roomgraph {
namespace {

constexpr double kNear = 1;  // [m]
constexpr int kSteps = 5;    // of the confidence
const std::array<const char*, 3> kVariants{"", "_furnitures", "_furnitures_trashbins"};

struct Count {
  std::size_t passages = 0, isTrue = 0;
};

/** By step of the confidence, and by reason. */
struct Counts {
  std::map<int, Count> bySteps;
  std::map<std::string, Count> byReasons;
};

using Votes = std::map<std::uint32_t, std::size_t>;  // by room of the truth

std::uint32_t winner(const Votes& votes) {
  std::pair<std::size_t, std::uint32_t> best{0, 0};
  for (const auto& [room, count] : votes) best = std::max(best, {count, room});
  return best.second;
}

bool isBetweenRooms(const Stages& stages, const LabelMap& truth, const Passage& passage) {
  const GridFrame& frame = stages.grid.frame;
  const Cell middle = frame.cellAt(passage.middle());
  const int reach = int(kNear / frame.resolution);
  Votes inA, inB;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y)
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      if (!frame.contains({x, y}) || distance(frame.center({x, y}), passage.middle()) > kNear)
        continue;
      const std::size_t column = std::size_t((x + 0.5) * truth.width / frame.width);
      const std::size_t row = std::size_t((y + 0.5) * truth.height / frame.height);
      const std::uint32_t room = truth.label[row * std::size_t(truth.width) + column];
      const std::size_t area = stages.areas.labels[frame.index({x, y})];
      if (room && area == passage.a.index() + 1) ++inA[room];
      if (room && area == passage.b.index() + 1) ++inB[room];
    }
  return winner(inA) != winner(inB);
}

void count(Counts& counts, const Stages& stages, const LabelMap& truth) {
  for (const Passage& passage : stages.areas.passages) {
    if (!passage.b) continue;
    const bool isTrue = isBetweenRooms(stages, truth, passage);
    for (Count* one : {&counts.bySteps[int(passage.evidence.confidence * kSteps)],
                       &counts.byReasons[nameOf(passage.evidence.reason)]}) {
      ++one->passages;
      one->isTrue += isTrue ? 1 : 0;
    }
  }
}

void printRow(const std::string& what, const Count& count) {
  std::printf("| %s | %zu | %.0f %% |\n", what.c_str(), count.passages,
              100.0 * double(count.isTrue) / double(count.passages));
}

void measure(const std::string& data) {
  for (const char* variant : kVariants) {
    Counts counts;
    for (const std::string& name : floorPlanNames(data)) {
      if (!hasFloorPlan(data, name, variant)) continue;
      const LabelMap truth = floorPlanTruth(data, name);
      count(counts, extract(floorPlan(data, name, variant, truth.width), {}), truth);
    }
    std::printf("| plans%s | passages | between two rooms |\n|---|---|---|\n", variant);
    for (const auto& [step, one] : counts.bySteps)
      printRow("from " + std::to_string(100 * step / kSteps) + " %", one);
    for (const auto& [reason, one] : counts.byReasons) printRow(reason, one);
    std::printf("\n");
  }
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Tells how many passages of each confidence lie between two rooms of a plan.");
  std::string data;
  app.add_option("--data", data, "folder of the map data; it holds room_seg/ipa")->required();
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::measure(data); });
}
