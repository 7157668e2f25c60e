#pragma once
#include "roomgraph/mrpt_plugin/CMapComparison.h"

namespace roomgraph::test {

/** Two runs of a room of 4 m, the second with a break. */
inline CMapComparison sampleMapComparison() {
  CMapComparison sample;
  Comparison& comparison = sample.comparison;
  comparison.verdict = "good is the best map";
  comparison.runs.resize(2);
  comparison.runs[0].name = "good", comparison.runs[1].name = "torn";
  comparison.runs[1].pose = {0.5, -0.25, 0.1};
  for (ComparedRun& run : comparison.runs) {
    run.file = run.name + ".simplemap", run.sha256 = std::string(64, 'a'), run.resolution = 0.05;
    std::vector<Point>& walls = sample.walls[run.name];
    for (int k = 0; k <= 80; ++k) {
      const double along = 0.05 * k;
      for (const Point wall : {Point{along, 0}, {along, 4}, {0, along}, {4, along}})
        walls.push_back(wall);
    }
  }
  SiteRoom room;
  room.id = room.name = "R1", room.area = 16, room.center = {2, 2};
  room.polygon.outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  comparison.rooms = {room};
  comparison.breaks = {{"torn", {1, 2}, 0.1, 0.5, 12, 1.7e9, TornPose{{1, 2, 0}, {1.5, 2, 0.1}}}};
  return sample;
}

}  // namespace roomgraph::test
