#include "sample_stages.h"

#include "roomgraph/pipeline/extract.h"

namespace roomgraph {
namespace {

constexpr int kWidth = 110, kHeight = 50;

GreyMap sampleMap() {
  GreyMap map;
  map.frame = {kWidth, kHeight, 0.1, {-1, -2}};
  map.grey.assign(map.frame.cellCount(), 127);
  map.source = {"some/folder/two rooms.png", "image", std::string(64, 'a'), ""};
  const auto fill = [&](Cell low, Cell high, std::uint8_t grey) {
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) map.grey[map.frame.index({x, y})] = grey;
  };
  fill({4, 4}, {86, 46}, 0);       // walls
  fill({5, 5}, {44, 45}, 255);     // left room
  fill({46, 5}, {85, 45}, 255);    // right room
  fill({45, 20}, {45, 29}, 255);   // door between them
  fill({86, 20}, {86, 29}, 255);   // door to the right
  fill({87, 20}, {104, 29}, 255);  // way out
  fill({20, 20}, {22, 22}, 0);     // a table
  map.occupiedAbove = 0.65;
  map.freeBelow = 0.196;
  return map;
}

Path straight(std::vector<Point> points, double minClearance) {
  Path path;
  path.length = length(points);
  path.points = std::move(points);
  path.minClearance = minClearance;
  return path;
}

Polygon square(Point low, Point high) {
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, {}};
}

TopologyGraph sampleGraph() {
  const RoomId left(0), right(1);
  std::vector<Vertex> vertices{
      {{1.45, 0.5}, 1.2345678, VertexKind::room, left},
      {{5.55, 0.5}, 1.95, VertexKind::room, right},
      {{3.5, 0.5}, 0.5, VertexKind::border, left},
      {{7.6, 0.5}, 0.5, VertexKind::border, right},
      {{8.4, 0.5}, 0.5, VertexKind::junction, RoomId::none()},
      {{9.2, 0.9}, 0.3, VertexKind::deadEnd, RoomId::none()},
      {{8.9, 0.2}, 0.3, VertexKind::ring, RoomId::none()},
  };
  const auto edge = [](std::size_t from, std::size_t to, RoomId room, Path path) {
    return Edge{VertexId(from), VertexId(to), std::move(path), room};
  };
  std::vector<Edge> edges{
      edge(0, 2, left, straight({{1.45, 0.5}, {3.5, 0.5}}, 0.5)),
      edge(1, 2, right, straight({{5.55, 0.5}, {3.5, 0.5}}, 0.5)),
      edge(1, 3, right, straight({{5.55, 0.5}, {7.6, 0.5}}, 0.5)),
      edge(3, 4, RoomId::none(), straight({{7.6, 0.5}, {8.0, 0.7}, {8.4, 0.5}}, 0.2)),
      edge(3, 4, RoomId::none(), straight({{7.6, 0.5}, {8.0, 0.3}, {8.4, 0.5}}, 0.2)),
      edge(4, 5, RoomId::none(), straight({{8.4, 0.5}, {8.8, 0.5}, {9.2, 0.9}}, 0.3)),
      edge(4, 6, RoomId::none(), straight({{8.4, 0.5}, {8.9, 0.2}}, 0.3)),
      edge(6, 6, RoomId::none(),
           straight({{8.9, 0.2}, {9.1, 0.1}, {9.2, 0.3}, {9.0, 0.4}, {8.9, 0.2}}, 0.1)),
  };
  return {std::move(vertices), std::move(edges)};
}

/** The two rooms, the dead end as corridor, and a cell of each with its label. */
AreaGraph sampleAreas(const Stages& stages) {
  AreaGraph areas;
  for (std::size_t i = 0; i < 2; ++i) {
    const Room& shape = stages.result.rooms[i].shape;
    areas.areas.push_back({RoomId(i), shape.polygon, shape.widestPlace, shape.inscribedRadius, {}});
  }
  areas.areas.push_back({RoomId::none(), square({7.65, 0}, {9.45, 0.95}), {8.5, 0.5}, 0.5, {}});
  const auto passage = [&](std::size_t a, std::size_t b, Point from, Point to) {
    const PassageId id(areas.passages.size());
    areas.passages.push_back({AreaId(a), AreaId(b), from, to, distance(from, to)});
    areas.areas[a].passages.push_back(id);
    areas.areas[b].passages.push_back(id);
  };
  passage(0, 1, {3.45, 2.55}, {3.45, -1.55});
  areas.passages.back().evidence = {0.87654321, PassageReason::wallOnBothSides};
  passage(1, 2, {7.55, 0.95}, {7.65, 0.00004});
  const GridFrame& frame = stages.grid.frame;
  areas.labels.assign(frame.cellCount(), 0);
  for (std::uint16_t i = 0; i < 3; ++i)
    areas.labels[frame.index(frame.cellAt(areas.areas[i].widestPlace))] = std::uint16_t(i + 1);
  areas.labels[frame.index({5, 5})] = 300;  // does not fit into 8 bits
  return areas;
}

}  // namespace

Stages sampleStages() {
  const GreyMap map = sampleMap();
  Stages stages;
  stages.source = map.source;
  stages.grid = {map.frame, {}};
  for (const auto grey : map.grey)
    stages.grid.cells.push_back(grey == 0     ? State::occupied
                                : grey == 255 ? State::free
                                              : State::unknown);
  stages.result.graph = sampleGraph();
  GraphRoom left{{square({-0.55, -1.55}, {3.45, 2.55}), {1.45, 0.5}, 1.9}, {1.45, 0.5}, {}, {}};
  left.shape.polygon.holes = {{{1, 0}, {1, 0.3}, {1.3, 0.3}, {1.3, 0}}};
  left.vertex = VertexId(0);
  left.borderVertices = {VertexId(2)};
  GraphRoom right{{square({3.55, -1.55}, {7.55, 2.55}), {5.55, 0.5}, 1.95}, {5.55, 0.5}, {}, {}};
  right.vertex = VertexId(1);
  right.borderVertices = {VertexId(2), VertexId(3)};
  stages.result.rooms = {left, right};
  stages.areas = sampleAreas(stages);
  stages.cleared.clutter = {{{1.15, 0.15}, 0.42}};
  stages.notes = {{"something", "has \"quotes\" and a place", std::array<double, 2>{1, 2.00001}},
                  {"another_thing", "has none", std::nullopt}};
  return stages;
}

Stages extractedStages() { return extract(sampleMap(), preset("default")); }

}  // namespace roomgraph
