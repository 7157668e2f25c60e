#include "draw_marks.h"

#include <algorithm>

#include "draw_stage.h"
#include "read_place.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/shapes.h"
#include "roomgraph/page/site_pictures.h"

namespace roomgraph {
namespace {

constexpr mrpt::img::TColor kRuler{110, 60, 150}, kRead{230, 0, 120}, kSwipeLine{20, 20, 20};
constexpr double kDot = 0.08;      // [m]
constexpr double kDotStep = 0.06;  // along a line [m]

viz::CDisk::Ptr dotAt(Point place, const mrpt::img::TColor& colour, double height = kMarkHeight) {
  return diskAt(place, height, colour, kDot);
}

/** As dots in a row: OpenGL's own lines are one pixel wide on most machines. */
viz::CPointCloud::Ptr lineThrough(const Polyline& points, bool isClosed,
                                  const mrpt::img::TColor& colour) {
  std::vector<Point> dots;
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    const auto count = std::max<std::size_t>(1, std::size_t(distance(a, b) / kDotStep));
    for (std::size_t k = 0; k <= count; ++k)
      dots.push_back(a + double(k) / double(count) * (b - a));
  }
  return pointsAt(dots, kMarkHeight, colour, 4);
}

void addOutline(const Polygon& polygon, viz::CSetOfObjects& set) {
  forEachRing(polygon, [&](const Ring& ring) { set.insert(lineThrough(ring, true, kRead)); });
}

/** The walls of a run, as the scene has them, that lie on one side of the line. */
viz::CPointCloud::Ptr wallsBeside(double line, bool isLeft, const View& view,
                                  const ComparedRun& run, MrptScene& scene) {
  const auto layer =
      std::dynamic_pointer_cast<viz::CSetOfObjects>(scene.getByName(runLayer(run.name)));
  const auto walls = layer ? layer->getByClass<viz::CPointCloud>() : nullptr;
  if (!walls) return viz::CPointCloud::Create();
  std::vector<Point> places;
  const auto offset = walls->getPose();
  const Motion2D move(run.pose);
  for (std::size_t i = 0; i < walls->size(); ++i) {
    const auto& p = walls->getPoint3Df(i);
    const Point place = move({double(p.x) + offset.x, double(p.y) + offset.y});
    if ((view.onScreen()(place).x < line) == isLeft) places.push_back(place);
  }
  return pointsAt(places, 0, walls->getColor_u8(), walls->getPointSize());
}

constexpr double kHeatCell = 0.2;  // no finer, so that turned maps leave no gaps [m]

std::vector<PlacedMap> placedMaps(const View& view) {
  std::vector<PlacedMap> placed;
  for (const ComparedRun& run : view.comparison.runs)
    if (const Run* map = view.runNamed(run.name))
      if (!map->map.states.empty()) placed.push_back({&map->map, run.pose});
  return placed;
}

void addSquare(const GridFrame& frame, Cell cell, Colour colour, viz::CSetOfTriangles& squares) {
  const Point middle = frame.center(cell);
  const double half = frame.resolution / 2;
  const auto at = [&](double x, double y) {
    return mrpt::math::TPoint3Df(float(middle.x + x * half), float(middle.y + y * half),
                                 float(kHeatHeight));
  };
  for (viz::TTriangle triangle : {viz::TTriangle(at(-1, -1), at(1, -1), at(1, 1)),
                                  viz::TTriangle(at(-1, -1), at(1, 1), at(-1, 1))}) {
    triangle.setColor(mrptColour(colour));
    squares.insertTriangle(triangle);
  }
}

}  // namespace

viz::CSetOfObjects::Ptr drawRuler(const std::vector<Point>& corners) {
  auto set = viz::CSetOfObjects::Create();
  set->insert(lineThrough(corners, false, kRuler));
  for (const Point corner : corners) set->insert(dotAt(corner, kRuler));
  return set;
}

viz::CSetOfObjects::Ptr drawRead(const View& view, const ViewState& state) {
  auto set = viz::CSetOfObjects::Create();
  if (!state.read) return set;
  set->insert(dotAt(*state.read, kRead));
  if (const SiteRoom* room = siteRoomAt(view, *state.read)) addOutline(room->polygon, *set);
  if (!view.graph) return set;
  const RoomGraph& graph = view.graph->file.graph;
  if (const auto room = roomAt(view, *state.read))
    addOutline(graph.rooms[*room].shape.polygon, *set);
  if (const auto edge = pathNear(view, *state.read))
    set->insert(lineThrough(graph.graph.edges()[*edge].path.points, false, kRead));
  return set;
}

viz::CSetOfObjects::Ptr drawSwipe(const View& view, const ViewState& state, const Box& box,
                                  MrptScene& scene) {
  auto set = viz::CSetOfObjects::Create();
  const auto other = otherRun(view, state);
  if (state.mode != Mode::swipe || !state.swipe || !other) return set;
  const auto& runs = view.comparison.runs;
  set->insert(wallsBeside(*state.swipe, true, view, runs[state.run], scene));
  set->insert(wallsBeside(*state.swipe, false, view, runs[*other], scene));
  const double height = box.high.y - box.low.y;
  const Transform2D site = view.onScreen().inverse();
  set->insert(lineThrough({site(Point{*state.swipe, box.low.y - height}),
                           site(Point{*state.swipe, box.high.y + height})},
                          false, kSwipeLine));
  return set;
}

mrpt::img::TColor colourOfError(const std::optional<double>& error) {
  if (!error) return {0, 82, 155};
  const double bad = std::clamp(*error / kWorstError, 0.0, 1.0);
  return {std::uint8_t(230 * std::min(1.0, 2 * bad)),
          std::uint8_t(170 * std::min(1.0, 2 - 2 * bad)), 40};
}

viz::CSetOfObjects::Ptr drawPath(const std::vector<PathPose>& path) {
  auto set = viz::CSetOfObjects::Create();
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    set->insert(linesAt({{path[k].pose.shift(), path[k + 1].pose.shift()}}, kPathHeight,
                        colourOfError(path[k + 1].error), 3));
  for (const PathPose& at : path)
    set->insert(dotAt(at.pose.shift(), colourOfError(at.error), kPathHeight));
  return set;
}

viz::CSetOfObjects::Ptr drawDisagreement(const View& view) {
  auto set = viz::CSetOfObjects::Create();
  const std::vector<PlacedMap> maps = placedMaps(view);
  if (maps.size() < 2) return set;
  double cell = kHeatCell;
  for (const PlacedMap& placed : maps) cell = std::max(cell, 2 * placed.map->frame.resolution);
  const Disagreement found = disagreementOf(maps, cell);
  auto squares = viz::CSetOfTriangles::Create();
  squares->enableLight(false);
  for (int y = 0; y < found.frame.height; ++y)
    for (int x = 0; x < found.frame.width; ++x) {
      const int level = heatLevel(double(found.shares[found.frame.index({x, y})]));
      if (level > 0)
        addSquare(found.frame, {x, y}, heatColours()[std::size_t(level - 1)], *squares);
    }
  set->insert(squares);
  return set;
}

}  // namespace roomgraph
