// How well the areas of maps that a robot has made agree with the labels of its building.
//
// Sites of simulated SLAM runs, each with its true plan, the labels of that and the true pose of
// each map in it. A map is read from its scans and extracted with the defaults; its areas are
// scored cell by cell against the labels that lie there, where the map is free. Runs that are off
// by 0.3 m or more are left out: labels do not lie where their rooms were drawn. What is room and
// what corridor nobody has labelled: a map is held against what was found on the plan itself.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "CsvTable.h"
#include "roomgraph/evaluation/score_rooms.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/images/read_labels.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"
#include "run_benchmark.h"
#include "simulated_site.h"

namespace roomgraph {
namespace {

constexpr double kLargestError = 0.3;  // of a map [m]

/** Cells of a site's maps, by the kind of area that they lie in on the plan: in how many of them
 *  the map says so, or the other one. */
struct KindCount {
  std::array<double, 2> all{}, wrong{};  // rooms, corridors

  double share(std::size_t kind) const { return all[kind] > 0 ? wrong[kind] / all[kind] : 0; }
  void add(const KindCount& other) {
    for (std::size_t kind = 0; kind < 2; ++kind)
      all[kind] += other.all[kind], wrong[kind] += other.wrong[kind];
  }
};

struct SiteSum {
  int maps = 0;
  double areas = 0, truths = 0, iouSeg = 0, iouTruth = 0, mcc = 0;
  KindCount kinds;

  void add(const SiteSum& other) {
    maps += other.maps, areas += other.areas, truths += other.truths;
    iouSeg += other.iouSeg, iouTruth += other.iouTruth, mcc += other.mcc;
    kinds.add(other.kinds);
  }
};

/** 0 for a room, 1 for corridor, 2 for neither. */
std::size_t kindAt(const Stages& stages, Cell cell) {
  if (!stages.grid.frame.contains(cell)) return 2;
  const std::uint16_t label = stages.areas.labels[stages.grid.frame.index(cell)];
  return label == 0 ? 2 : stages.areas.areas[label - 1u].isRoom() ? 0 : 1;
}

SiteSum scoreMap(const Stages& map, const Transform2D& pose, const Stages& plan,
                 const LabelMap& labels) {
  const GridFrame &frame = map.grid.frame, &planFrame = plan.grid.frame;
  const auto& found = map.areas.labels;
  const LabelMap areas{frame.width, frame.height, {found.begin(), found.end()}, {}};
  LabelMap truth{frame.width, frame.height, std::vector<std::uint32_t>(frame.cellCount()), {}};
  SiteSum sum;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const Cell there = planFrame.cellAt(pose(frame.center({x, y})));
      if (map.grid.at({x, y}) != State::free || !planFrame.contains(there)) continue;
      truth.label[frame.index({x, y})] = labels.label[planFrame.index(there)];
      const std::size_t told = kindAt(map, {x, y}), right = kindAt(plan, there);
      if (told == 2 || right == 2) continue;
      ++sum.kinds.all[right], sum.kinds.wrong[right] += told != right ? 1 : 0;
    }
  const RoomScore score = scoreRooms(areas, truth);
  sum.maps = 1, sum.areas = double(score.seg.count), sum.truths = double(score.truth.count);
  sum.iouSeg = score.iouSeg.value_or(0), sum.iouTruth = score.iouTruth.value_or(0);
  sum.mcc = score.mcc.value_or(0);
  return sum;
}

SiteSum scoreSite(const std::string& folder) {
  const ExtractOptions options;
  const auto extracted = [&](const std::string& name) {
    return extract(loadGrid(folder + '/' + name, options.loadGrid), options);
  };
  const Stages plan = extracted("truth.gridmap.gz");
  const LabelMap labels = readLabels(folder + "/truth_labels.png");
  const CsvTable table(folder + "/truth.csv");
  SiteSum sum;
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.number(row, "map_rms_m") >= kLargestError) continue;
    const Stages map = extracted(table.text(row, "run") + ".simplemap.gz");
    sum.add(scoreMap(map, table.pose(row, "A"), plan, labels));
  }
  return sum;
}

void print(const std::string& name, const SiteSum& sum) {
  const double maps = std::max(1, sum.maps);
  std::printf("| %s | %d | %.1f | %.1f | %.1f | %.1f | %.3f | %.1f | %.1f |\n", name.c_str(),
              sum.maps, sum.areas / maps, sum.truths / maps, 100 * sum.iouSeg / maps,
              100 * sum.iouTruth / maps, sum.mcc / maps, 100 * sum.kinds.share(1),
              100 * sum.kinds.share(0));
  std::fflush(stdout);
}

void measure(const std::string& data, const std::string& only) {
  std::printf(
      "| site | maps | areas | true areas | IoU seg | IoU truth | MCC | corridor told as room [%%] "
      "| room told as corridor [%%] |\n|---|---|---|---|---|---|---|---|---|\n");
  SiteSum all;
  for (const std::string& folder : simulatedSites(data, only)) {
    const SiteSum sum = scoreSite(folder);
    print(std::filesystem::path(folder).filename().string(), sum);
    all.add(sum);
  }
  print("**all maps**", all);
}

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app("Scores rooms and corridors of simulated runs against the labels of their plans.");
  std::string data, only;
  roomgraph::declareSites(data, only, app);
  return roomgraph::runBenchmark(app, argc, argv, [&] { roomgraph::measure(data, only); });
}
