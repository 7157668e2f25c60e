#include "draw_marks.h"

#include <algorithm>

#include "heights.h"
#include "read_place.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"

namespace roomgraph {
namespace {

constexpr mrpt::img::TColor kRuler{110, 60, 150}, kRead{230, 0, 120}, kSwipeLine{20, 20, 20};
constexpr float kDot = 0.08f;      // [m]
constexpr double kDotStep = 0.06;  // along a line [m]

viz::CDisk::Ptr dotAt(Point at, const mrpt::img::TColor& colour) {
  auto dot = viz::CDisk::Create(kDot, 0.0f);
  dot->setColor_u8(colour);
  dot->setLocation(at.x, at.y, kMarkHeight);
  return dot;
}

/** As dots in a row: OpenGL's own lines are one pixel wide on most machines. */
viz::CPointCloud::Ptr lineThrough(const Polyline& points, bool isClosed,
                                  const mrpt::img::TColor& colour) {
  auto line = viz::CPointCloud::Create();
  line->setColor_u8(colour);
  line->setPointSize(4);
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    const auto count = std::max<std::size_t>(1, std::size_t(distance(a, b) / kDotStep));
    for (std::size_t k = 0; k <= count; ++k) {
      const Point p = a + double(k) / double(count) * (b - a);
      line->insertPoint(float(p.x), float(p.y), float(kMarkHeight));
    }
  }
  return line;
}

void addOutline(const Polygon& polygon, viz::CSetOfObjects& set) {
  set.insert(lineThrough(polygon.outer, true, kRead));
  for (const Ring& hole : polygon.holes) set.insert(lineThrough(hole, true, kRead));
}

/** The walls of a run, as the scene has them, that lie on one side of the line. */
viz::CPointCloud::Ptr wallsBeside(double line, bool isLeft, const std::string& run,
                                  const Transform2D& pose, MrptScene& scene) {
  auto cloud = viz::CPointCloud::Create();
  const auto layer = std::dynamic_pointer_cast<viz::CSetOfObjects>(scene.getByName(runLayer(run)));
  const auto walls = layer ? layer->getByClass<viz::CPointCloud>() : nullptr;
  if (!walls) return cloud;
  cloud->setColor_u8(walls->getColor_u8());
  cloud->setPointSize(walls->getPointSize());
  const auto offset = walls->getPose();
  const Motion2D move(pose);
  for (std::size_t i = 0; i < walls->size(); ++i) {
    const auto& p = walls->getPoint3Df(i);
    const Point at = move({double(p.x) + offset.x, double(p.y) + offset.y});
    if ((at.x < line) == isLeft) cloud->insertPoint(float(at.x), float(at.y), 0);
  }
  return cloud;
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
  set->insert(wallsBeside(*state.swipe, true, runs[state.run].name, runs[state.run].pose, scene));
  set->insert(wallsBeside(*state.swipe, false, runs[*other].name, runs[*other].pose, scene));
  const double height = box.high.y - box.low.y;
  set->insert(lineThrough({{*state.swipe, box.low.y - height}, {*state.swipe, box.high.y + height}},
                          false, kSwipeLine));
  return set;
}

}  // namespace roomgraph
