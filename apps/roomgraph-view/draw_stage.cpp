#include "draw_stage.h"

#include <algorithm>

#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/stage_names.h"
#include "roomgraph/mrpt_plugin/CRoomGraph.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/mrpt_plugin/shapes.h"

namespace roomgraph {
namespace {

constexpr mrpt::img::TColor kObstacles = mrptColour(ink::vermilion),
                            kVoronoi = mrptColour(ink::blue),
                            kPassages = mrptColour(ink::vermilion);

viz::CSetOfObjects::Ptr setOf(const MrptObject::Ptr& object) {
  auto set = viz::CSetOfObjects::Create();
  set->insert(object);
  return set;
}

std::vector<Point> placesOf(const ObstacleCells& obstacles) {
  return mapped(obstacles.cells, [&](Cell cell) { return obstacles.frame.center(cell); });
}

viz::CSetOfLines::Ptr edgesOf(const VoronoiGraph& voronoi, const std::vector<bool>& isShown) {
  std::vector<Segment> ends;
  for (std::size_t e = 0; e < isShown.size(); ++e)
    if (isShown[e])
      ends.emplace_back(voronoi.vertices[voronoi.edges[e].source].place,
                        voronoi.vertices[voronoi.edges[e].target].place);
  return linesAt(ends, kStageHeight, kVoronoi, 1);
}

/** A graph with the floors of rooms, none of which is a vertex yet. */
viz::CSetOfObjects::Ptr graphOf(const TopologyGraph& graph, const Rooms& rooms) {
  MappedGraph drawn;
  drawn.file.graph.graph = graph;
  for (const Room& room : rooms) {
    drawn.file.graph.rooms.emplace_back();
    drawn.file.graph.rooms.back().shape = room;
  }
  return drawGraph(drawn);
}

viz::CSetOfObjects::Ptr areasOf(const AreaGraph& areas) {
  const Rooms shapes = mapped(areas.areas, [](const Area& area) {
    return Room{area.polygon, area.widestPlace, area.inscribedRadius, 0};
  });
  const auto ends = mapped(areas.passages, [](const Passage& p) { return Segment(p.from, p.to); });
  auto all = setOf(graphOf({}, shapes));
  all->insert(linesAt(ends, kStageHeight, kPassages, 3));
  return all;
}

viz::CSetOfObjects::Ptr bordersOf(const Stages& stages) {
  auto set = setOf(graphOf(stages.kept, stages.rooms));
  set->insert(pointsAt(crossings(stages), kStageHeight, kObstacles, 7));
  return set;
}

std::string countText(std::size_t count, const char* things) {
  return "; " + std::to_string(count) + " " + things;
}

std::string countsOf(const TopologyGraph& graph) {
  return countText(graph.vertices().size(), "vertices") + countText(graph.edges().size(), "edges");
}

std::string countsAt(const Stages& stages, ShownStage stage) {
  const StageName& shown = stageNames()[std::size_t(stage)];
  if (shown.graph) return countsOf(stages.*shown.graph);
  if (shown.edges) {
    const std::vector<bool> edges = shown.edges(stages);
    return countText(std::size_t(std::count(edges.begin(), edges.end(), true)), "edges");
  }
  switch (stage) {
    case ShownStage::obstacles:
      return countText(stages.obstacles.cells.size(), "obstacle cells");
    case ShownStage::rooms:
      return countText(stages.rooms.size(), "rooms");
    case ShownStage::borderVertices:
      return countText(crossings(stages).size(), "crossings");
    case ShownStage::result:
      return countsOf(stages.result.graph);
    case ShownStage::areas:
      return countText(stages.areas.areas.size(), "areas") +
             countText(stages.areas.passages.size(), "passages");
    default:
      return "";
  }
}

}  // namespace

viz::CSetOfObjects::Ptr drawStage(const Stages& stages, std::size_t number) {
  const auto stage = ShownStage(number);
  const StageName& shown = stageNames()[number];
  if (shown.edges) return setOf(edgesOf(stages.voronoi, shown.edges(stages)));
  if (shown.graph)
    return graphOf(stages.*shown.graph, stage < ShownStage::cut ? Rooms() : stages.rooms);
  switch (stage) {
    case ShownStage::obstacles:
      return setOf(pointsAt(placesOf(stages.obstacles), kStageHeight, kObstacles, 2));
    case ShownStage::rooms:
      return graphOf({}, stages.rooms);
    case ShownStage::borderVertices:
      return bordersOf(stages);
    case ShownStage::areas:
      return areasOf(stages.areas);
    case ShownStage::result:
      return drawGraph(CRoomGraph(stages));
    default:
      return viz::CSetOfObjects::Create();  // the grid is the map itself
  }
}

std::string stageLine(const Stages& stages, std::size_t stage) {
  const StageName& name = stageNames()[stage];
  return "stage " + std::to_string(stage + 1) + " of " + std::to_string(stageNames().size()) +
         " (" + name.paper + "): " + name.title + countsAt(stages, ShownStage(stage));
}

}  // namespace roomgraph
