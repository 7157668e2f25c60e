#include "roomgraph/drawing/draw_stages.h"

#include <algorithm>

#include "draw_layers.h"
#include "render.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/drawing/stage_names.h"
#include "roomgraph/topology/kind_names.h"

namespace roomgraph {
namespace {

/** One step: what it counts, what it shows. */
// NOLINTNEXTLINE(bugprone-exception-escape): JSON throws nothing when it is moved
struct Picture {
  Json counts;
  Scene scene;
};

std::vector<const Polygon*> polygonsOf(const Rooms& rooms) {
  return mapped(rooms, [](const Room& room) { return &room.polygon; });
}

Picture gridPicture(const Stages& stages) {
  Picture picture;
  const auto& cells = stages.grid.cells;
  const auto count = [&](State state) { return std::count(cells.begin(), cells.end(), state); };
  picture.counts = {{"free", count(State::free)},
                    {"occupied", count(State::occupied)},
                    {"unknown", count(State::unknown)}};
  picture.scene.legend = stateLegend(stages.grid);
  return picture;
}

Picture obstaclesPicture(const Stages& stages) {
  const std::size_t count = stages.obstacles.cells.size();
  Picture picture{Json::object({{"obstacle_cells", count}}), {}};
  picture.scene.layers = [&stages](const Pen& pen) { drawObstacles(pen, stages.obstacles); };
  picture.scene.legend = {
      squareLegend(groupedCount(count, "obstacle cell", "obstacle cells"), ink::vermilion)};
  return picture;
}

/** The edges of the Voronoi diagram that a filter leaves. */
Picture voronoiPicture(const Stages& stages, std::vector<bool> isShown) {
  const auto count = std::size_t(std::count(isShown.begin(), isShown.end(), true));
  Picture picture{Json::object({{"edges", count}}), {}};
  picture.scene.legend = {
      lineLegend(groupedCount(count, "Voronoi edge", "Voronoi edges"), ink::blue, 1.2)};
  picture.scene.layers = [&stages, shown = std::move(isShown)](const Pen& pen) {
    drawVoronoi(
        pen, stages.voronoi, [&](std::size_t e) { return shown[e]; }, ink::blue);
  };
  return picture;
}

Json graphCounts(const TopologyGraph& graph) {
  Json counts{{"vertices", graph.vertices().size()}, {"edges", graph.edges().size()}};
  for (const Vertex& vertex : graph.vertices()) {
    Json& count = counts[nameOf(vertex.kind)];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  return counts;
}

Picture graphPicture(const TopologyGraph& graph, const Rooms* rooms) {
  Picture picture{graphCounts(graph), {}};
  picture.scene.layers = [&graph, rooms](const Pen& pen) {
    if (rooms) drawRooms(pen, polygonsOf(*rooms));
    drawPaths(pen, graph);
    drawVertices(pen, graph);
  };
  picture.scene.legend = graphLegend(graph);
  return picture;
}

Picture roomsPicture(const Stages& stages) {
  const std::size_t count = stages.rooms.size();
  Picture picture{Json::object({{"rooms", count}}), {}};
  picture.scene.layers = [&stages](const Pen& pen) {
    drawRooms(pen, polygonsOf(stages.rooms));
    for (const Room& room : stages.rooms)
      pen.mark(VertexKind::room, pen.view().px(room.widestPlace));
  };
  picture.scene.legend = {roomLegend(count)};
  return picture;
}

Picture borderPicture(const Stages& stages) {
  const std::vector<Point> places = crossings(stages);
  Picture picture{Json::object({{"crossings", places.size()}}), {}};
  picture.scene.layers = [&stages, places](const Pen& pen) {
    drawRooms(pen, polygonsOf(stages.rooms));
    drawPaths(pen, stages.kept);
    for (const Point p : places) pen.mark(VertexKind::border, pen.view().px(p));
  };
  picture.scene.legend = {
      roomLegend(stages.rooms.size()),
      {groupedCount(places.size(), "crossing", "crossings"),
       [](const Pen& pen, Point place) { pen.mark(VertexKind::border, place); }},
      lineLegend(groupedCount(stages.kept.edges().size(), "path", "paths"), ink::blue, 2)};
  return picture;
}

Picture resultPicture(const Stages& stages) {
  Picture picture{graphCounts(stages.result.graph), resultScene(stages)};
  picture.counts["rooms"] = stages.result.rooms.size();
  return picture;
}

Picture areasPicture(const Stages& stages) {
  const std::vector<Area>& areas = stages.areas.areas;
  const auto rooms = countIf(areas, &Area::isRoom);
  const std::size_t corridors = areas.size() - rooms;
  Picture picture{Json::object({{"rooms", rooms},
                                {"corridors", corridors},
                                {"passages", stages.areas.passages.size()},
                                {"clutter", stages.cleared.clutter.size()}}),
                  {}};
  picture.scene.layers = [&stages](const Pen& pen) {
    drawRooms(pen, mapped(stages.areas.areas, [](const Area& area) { return &area.polygon; }));
    drawClutter(pen, stages.cleared.clutter);
    drawPassages(pen, stages.areas.passages);
    drawRoomLabels(pen, stages.result.rooms);
  };
  picture.scene.legend = {
      roomLegend(rooms),
      {groupedCount(corridors, "corridor", "corridors"), [](const Pen& pen, Point place) {
         pen.traceBox(place, {9, 6});
         pen.paint(ink::sky, 0.34, ink::blue, 0.7, 1.2);
       }}};
  for (const LegendItem& item : areaLegend(stages)) picture.scene.legend.push_back(item);
  return picture;
}

Picture pictureOf(const Stages& stages, ShownStage stage) {
  const StageName& shown = stageNames()[std::size_t(stage)];
  if (shown.edges) return voronoiPicture(stages, shown.edges(stages));
  if (shown.graph)
    return graphPicture(stages.*shown.graph, stage < ShownStage::cut ? nullptr : &stages.rooms);
  switch (stage) {
    case ShownStage::grid:
      return gridPicture(stages);
    case ShownStage::obstacles:
      return obstaclesPicture(stages);
    case ShownStage::rooms:
      return roomsPicture(stages);
    case ShownStage::borderVertices:
      return borderPicture(stages);
    case ShownStage::areas:
      return areasPicture(stages);
    default:
      return resultPicture(stages);
  }
}

std::string twoDigits(std::size_t number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/** Of the picture of a step, by its place in stageNames(). */
std::string pictureName(std::size_t step) {
  return twoDigits(step + 1) + "_" + stageNames()[step].name + ".png";
}

constexpr char kList[] = "stages.json";

}  // namespace

std::vector<std::string> stageFiles() {
  std::vector<std::string> names;
  for (std::size_t step = 0; step < stageNames().size(); ++step) names.push_back(pictureName(step));
  names.emplace_back(kList);
  return names;
}

void drawStages(const Stages& stages, const std::string& folder, StagedFiles& files) {
  makeWritableFolder(folder);
  const std::string map = fileName(stages.source.file);
  JsonDocument document("roomgraph/stages", nullptr);
  document.addEntries("stages", stageNames().size(), [&](std::size_t step) {
    const StageName& stage = stageNames()[step];
    Picture picture = pictureOf(stages, ShownStage(step));
    const std::string file = pictureName(step);
    const std::string heading = twoDigits(step + 1) + " " + stage.name;
    picture.scene.title = heading + "  ·  " + stage.paper + "  ·  " + stage.title;
    picture.scene.subtitle = map + "  ·  " + resolutionText(stages.grid.frame.resolution);
    files.add(folder + "/" + file, renderPng(stages.grid, picture.scene));
    return lineOf({{"file", file},
                   {"paper", stage.paper},
                   {"title", stage.title},
                   {"counts", picture.counts}});
  });
  files.add(folder + "/" + kList, std::move(document).text());
}

}  // namespace roomgraph
