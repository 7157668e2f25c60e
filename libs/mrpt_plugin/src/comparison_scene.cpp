#include "roomgraph/mrpt_plugin/comparison_scene.h"

#include <algorithm>

#include "look_from_above.h"
#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"

namespace roomgraph {

MrptScene comparisonScene(const Comparison& comparison, const std::vector<Run>& runs) {
  return comparisonScene(CMapComparison(comparison, runs));
}

MrptScene comparisonScene(const CMapComparison& compared) {
  MrptScene scene;
  const auto drawn = drawComparison(compared.comparison, compared.walls);
  for (const auto& layer : *drawn) scene.insert(layer);
  Box box = drawnBox(compared.comparison, compared.walls);
  box.low.y -= kLegendLine * letterHeight(box) *
               double(std::min(compared.comparison.runs.size(), kMostNamed));
  lookFromAbove(scene, box);
  return scene;
}

std::string comparisonSceneBytes(const Comparison& comparison, const std::vector<Run>& runs) {
  return gzippedObject(comparisonScene(comparison, runs));
}

std::string comparisonSceneBytes(const CMapComparison& compared) {
  return gzippedObject(comparisonScene(compared));
}

}  // namespace roomgraph
