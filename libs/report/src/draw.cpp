#include "roomgraph/report/draw.h"

#include <filesystem>
#include <sstream>

#include "draw_layers.h"
#include "render.h"
#include "result_scene.h"

namespace roomgraph {

std::string resolutionText(double metres) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << metres << " m per cell";
  return text.str();
}

Scene resultScene(const Stages& stages) {
  const RoomGraph& result = stages.result;
  const TopologyGraph& graph = result.graph;
  Scene scene;
  scene.title = std::filesystem::path(stages.source.file).filename().string();
  scene.subtitle = counted(result.rooms.size(), "room", "rooms") + "  ·  " +
                   counted(graph.vertices().size(), "vertex", "vertices") + "  ·  " +
                   counted(graph.edges().size(), "edge", "edges") + "  ·  " +
                   resolutionText(stages.grid.frame.resolution);
  scene.layers = [&stages](const Pen& pen) {
    std::vector<const Polygon*> polygons;
    for (const GraphRoom& room : stages.result.rooms) polygons.push_back(&room.shape.polygon);
    drawRooms(pen, polygons);
    drawPaths(pen, stages.result.graph);
    drawVertices(pen, stages.result.graph);
    drawRoomLabels(pen, stages.result.rooms);
  };
  if (!result.rooms.empty()) scene.legend.push_back(roomLegend(result.rooms.size()));
  for (const auto& items : {graphLegend(graph), stateLegend(stages.grid)})
    scene.legend.insert(scene.legend.end(), items.begin(), items.end());
  return scene;
}

std::string drawPng(const Stages& stages) { return renderPng(stages.grid, resultScene(stages)); }

std::string drawSvg(const Stages& stages) { return renderSvg(stages.grid, resultScene(stages)); }

}  // namespace roomgraph
