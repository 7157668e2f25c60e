#include "roomgraph/mrpt_plugin/comparison_scene.h"

#include <algorithm>

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {

MrptScene comparisonScene(const Comparison& comparison, const std::vector<Run>& runs) {
  const double turn = uprightTurn(comparison, runs);
  const RunWalls walls = runWalls(runs);
  MrptScene scene;
  const auto drawn = drawComparison(comparison, walls, turn);
  for (const auto& layer : *drawn) scene.insert(layer);
  Box box = drawnBox(comparison, walls, turn);
  box.low.y -=
      kLegendLine * letterHeight(box) * double(std::min(comparison.runs.size(), kMostNamed));
  lookFromAbove(scene, box, turn);
  return scene;
}

std::string comparisonSceneBytes(const Comparison& comparison, const std::vector<Run>& runs) {
  return gzippedObject(comparisonScene(comparison, runs));
}

}  // namespace roomgraph
