#include "roomgraph/drawing/draw.h"

#include <sstream>

#include "draw_layers.h"
#include "render.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sequences.h"

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
  scene.title = fileName(stages.source.file);
  scene.subtitle = groupedCount(result.rooms.size(), "room", "rooms") + "  ·  " +
                   groupedCount(graph.vertices().size(), "vertex", "vertices") + "  ·  " +
                   groupedCount(graph.edges().size(), "edge", "edges") + "  ·  " +
                   resolutionText(stages.grid.frame.resolution);
  scene.layers = [&stages](const Pen& pen) {
    drawRooms(pen, mapped(stages.result.rooms,
                          [](const GraphRoom& room) { return &room.shape.polygon; }));
    drawClutter(pen, stages.cleared.clutter);
    drawPassages(pen, stages.areas.passages);
    drawPaths(pen, stages.result.graph);
    drawVertices(pen, stages.result.graph);
    drawRoomLabels(pen, stages.result.rooms);
  };
  if (!result.rooms.empty()) scene.legend.push_back(roomLegend(result.rooms.size()));
  const auto add = [&](const std::vector<LegendItem>& items) {
    scene.legend.insert(scene.legend.end(), items.begin(), items.end());
  };
  add(graphLegend(graph));
  add(areaLegend(stages));
  add(stateLegend(stages.grid));
  return scene;
}

std::string drawPng(const Stages& stages) { return renderPng(stages.grid, resultScene(stages)); }

std::string drawSvg(const Stages& stages) { return renderSvg(stages.grid, resultScene(stages)); }

}  // namespace roomgraph
