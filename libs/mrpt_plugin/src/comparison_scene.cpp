#include "roomgraph/mrpt_plugin/comparison_scene.h"

#include <algorithm>

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {

namespace {

/** With a camera for which the site is turned by `turn` [rad]. */
MrptScene sceneTurned(const CMapComparison& compared, double turn) {
  MrptScene scene;
  const auto drawn = drawComparison(compared.comparison, compared.walls, turn);
  for (const auto& layer : *drawn) scene.insert(layer);
  Box box = drawnBox(compared.comparison, compared.walls, turn);
  box.low.y -= kLegendLine * letterHeight(box) *
               double(std::min(compared.comparison.runs.size(), kMostNamed));
  lookFromAbove(scene, box, turn);
  return scene;
}

}  // namespace

MrptScene comparisonScene(const Comparison& comparison, const std::vector<Run>& runs) {
  return sceneTurned(CMapComparison(comparison, runs), uprightTurn(comparison, runs));
}

MrptScene comparisonScene(const CMapComparison& compared) { return sceneTurned(compared, 0); }

std::string comparisonSceneBytes(const Comparison& comparison, const std::vector<Run>& runs) {
  return gzippedObject(comparisonScene(comparison, runs));
}

std::string comparisonSceneBytes(const CMapComparison& compared) {
  return gzippedObject(comparisonScene(compared));
}

}  // namespace roomgraph
