#include "drawn_house.h"

#include <cmath>

#include "roomgraph/align/wall_map.h"
#include "sampled_grid.h"

namespace roomgraph::test {
namespace {

constexpr double kHouseCell = 0.05, kHouseWall = 0.15, kDoor = 0.45;  // half a door

bool isIn(const House::RoomBox& box, Point p, double more) {
  return p.x > box.low.x - more && p.x < box.high.x + more && p.y > box.low.y - more &&
         p.y < box.high.y + more;
}

State stateAt(const House& house, Point p) {
  for (const House::DoorBox& door : house.doors)
    if (std::abs(p.x - door.place.x) < kDoor && std::abs(p.y - door.place.y) < kDoor)
      return State::free;
  for (const House::RoomBox& box : house.rooms)
    if (isIn(box, p, 0)) return State::free;
  for (const House::RoomBox& box : house.rooms)
    if (isIn(box, p, kHouseWall)) return State::occupied;
  return State::unknown;
}

/** The place of the house that is drawn at `p`. */
Point undrawn(const House& house, Point p) {
  const Point about{house.bendAt, 5};
  const Point back = turned(p - about - house.shift, -house.bend) + about;
  return back.x > house.bendAt ? back : p;
}

/** Corners every half metre, so that what crosses the bend bends. */
Ring outline(const House& house, const House::RoomBox& box, const Transform2D& pose) {
  const std::vector<Point> corners{
      box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = corners[i], b = corners[(i + 1) % 4];
    const int steps = int(distance(a, b) / 0.5) + 1;
    for (int k = 0; k < steps; ++k)
      ring.push_back(pose(house.drawn(a + (double(k) / steps) * (b - a))));
  }
  return ring;
}

AreaGraph areasOf(const House& house, const Transform2D& pose) {
  AreaGraph graph;
  std::vector<AreaId> ids;
  for (const House::RoomBox& box : house.rooms) {
    ids.push_back(box.isArea ? AreaId(graph.areas.size()) : AreaId::none());
    if (!box.isArea) continue;
    Area area;
    if (!box.isCorridor) area.room = RoomId(graph.areas.size());
    area.polygon.outer = outline(house, box, pose);
    graph.areas.push_back(area);
  }
  for (const House::DoorBox& door : house.doors) {
    if (!ids[door.a] || !ids[door.b]) continue;
    const Point at = pose(house.drawn(door.place));
    graph.passages.push_back({ids[door.a], ids[door.b], at, at, 2 * kDoor});
  }
  return graph;
}

}  // namespace

Point House::drawn(Point p) const {
  const Point about{bendAt, 5};
  return p.x > bendAt ? turned(p - about, bend) + about + shift : p;
}

House house() {
  House h;
  h.rooms.push_back({{0, 4}, {20, 6}, true});
  const std::vector<double> below{0, 3, 7, 12, 16, 20}, above{0, 4.5, 8, 11, 15.5, 20};
  for (std::size_t i = 0; i + 1 < below.size(); ++i) {
    h.rooms.push_back({{below[i] + 0.1, 0}, {below[i + 1] - 0.1, 3.8}});
    h.doors.push_back({0, h.rooms.size() - 1, {below[i] + 1, 3.9}});
  }
  for (std::size_t i = 0; i + 1 < above.size(); ++i) {
    h.rooms.push_back({{above[i] + 0.1, 6.2}, {above[i + 1] - 0.1, 11}});
    h.doors.push_back({0, h.rooms.size() - 1, {above[i + 1] - 1.5, 6.1}});
  }
  return h;
}

Run runOf(const House& house, const std::string& name, const Transform2D& pose) {
  const Point middle = pose({10, 5});
  const double half = 18;  // all of it, however it is turned
  const GridFrame frame{int(2 * half / kHouseCell), int(2 * half / kHouseCell), kHouseCell,
                        middle - Point{half, half}};
  const Transform2D back = pose.inverse();
  Run run;
  run.name = name, run.file = name + ".gridmap", run.sha256 = "hash of " + name;
  run.map =
      wallMap(sampledGrid(frame, [&](Point p) { return stateAt(house, undrawn(house, back(p))); }));
  run.areas = areasOf(house, pose);
  return run;
}

}  // namespace roomgraph::test
