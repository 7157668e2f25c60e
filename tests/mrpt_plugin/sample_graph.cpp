#include "sample_graph.h"

#include <cmath>

namespace roomgraph {
namespace {

constexpr double kResolution = 0.1;

struct Rectangle {
  double left, bottom, right, top;
};

// Round the origin, where RawLogViewer looks.
constexpr Rectangle kMap{-12, -8, 12, 8}, kCorridor{-11, -1, 11, 1},
    kPillar{-4.5, -4.5, -3.5, -3.5};
constexpr Rectangle kRooms[] = {
    {-11, 1.2, -1, 7}, {-0.8, 1.2, 11, 7}, {-11, -7, 3, -1.2}, {3.2, -7, 11, -1.2}};
constexpr Rectangle kDoors[] = {{-6.5, 1, -5.5, 1.2},
                                {4.5, 1, 5.5, 1.2},
                                {-4.5, -1.2, -3.5, -1},
                                {6.5, -1.2, 7.5, -1},
                                {3, -5.5, 3.2, -4.5}};

Ring counterClockwise(const Rectangle& r) {
  return {{r.left, r.bottom}, {r.right, r.bottom}, {r.right, r.top}, {r.left, r.top}};
}

Ring clockwise(const Rectangle& r) {
  return {{r.left, r.bottom}, {r.left, r.top}, {r.right, r.top}, {r.right, r.bottom}};
}

void fill(Grid& grid, const Rectangle& r, State state) {
  const auto cells = [](double metres) { return int(std::lround(metres / kResolution)); };
  for (int y = cells(r.bottom - kMap.bottom); y < cells(r.top - kMap.bottom); ++y)
    for (int x = cells(r.left - kMap.left); x < cells(r.right - kMap.left); ++x)
      grid.cells[grid.frame.index({x, y})] = state;
}

Grid sampleMap() {
  Grid grid{{240, 160, kResolution, {kMap.left, kMap.bottom}},
            std::vector<State>(240 * 160, State::unknown)};
  for (const Rectangle& r : kRooms)
    fill(grid, {r.left - 0.2, r.bottom - 0.2, r.right + 0.2, r.top + 0.2}, State::occupied);
  fill(grid, {-11.2, -1, 11.2, 1}, State::occupied);
  for (const Rectangle& r : kRooms) fill(grid, r, State::free);
  fill(grid, kCorridor, State::free);
  for (const Rectangle& r : kDoors) fill(grid, r, State::free);
  fill(grid, kPillar, State::occupied);
  return grid;
}

struct Builder {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;

  VertexId add(VertexKind kind, Point at, RoomId room = {}) {
    vertices.push_back({at, 1, kind, room});
    return VertexId(vertices.size() - 1);
  }
  void join(VertexId a, VertexId b, RoomId room = {}, Polyline between = {}) {
    Path path;
    path.points.push_back(vertices[a.index()].place);
    path.points.insert(path.points.end(), between.begin(), between.end());
    path.points.push_back(vertices[b.index()].place);
    path.length = length(path.points);
    path.minClearance = 0.5;
    if (!room) path.obstacles.assign(path.points.size() - 1, {0, 1});
    edges.push_back({a, b, path, room});
  }
};

void addRooms(Builder& build, std::vector<GraphRoom>& rooms, const VertexId (&doors)[5]) {
  for (std::size_t i = 0; i < 4; ++i) {
    GraphRoom room;
    room.shape.polygon.outer = counterClockwise(kRooms[i]);
    if (i == 2) room.shape.polygon.holes = {clockwise(kPillar)};
    room.center = i == 2 ? Point{-7.5, -4} : centroid(room.shape.polygon);
    room.shape.widestPlace = room.center;
    room.shape.inscribedRadius = 2.9;
    room.vertex = build.add(VertexKind::room, room.center, RoomId(i));
    room.borderVertices = {doors[i]};
    build.join(room.vertex, doors[i], RoomId(i));
    if (i >= 2) {
      room.borderVertices.push_back(doors[4]);
      build.join(room.vertex, doors[4], RoomId(i),
                 i == 2 ? Polyline{{-5.5, -5.5}, {-1, -5.5}} : Polyline{});
    }
    rooms.push_back(room);
  }
}

RoomGraph sampleRooms() {
  Builder build;
  const VertexId doors[5] = {build.add(VertexKind::border, {-6, 1.2}, RoomId(0)),
                             build.add(VertexKind::border, {5, 1.2}, RoomId(1)),
                             build.add(VertexKind::border, {-4, -1.2}, RoomId(2)),
                             build.add(VertexKind::border, {7, -1.2}, RoomId(3)),
                             build.add(VertexKind::border, {3.1, -5}, RoomId(2))};
  RoomGraph graph;
  addRooms(build, graph.rooms, doors);
  const VertexId ring = build.add(VertexKind::ring, {-8.8, 0});
  VertexId last = ring;
  build.join(ring, ring, {}, {{-9.1, 0.5}, {-9.8, 0.7}, {-10.4, 0}, {-9.8, -0.7}, {-9.1, -0.5}});
  const std::pair<double, std::size_t> crossings[] = {{-6, 0}, {-4, 2}, {5, 1}, {7, 3}};
  for (const auto& [x, door] : crossings) {
    const VertexId here = build.add(VertexKind::junction, {x, 0});
    build.join(last, here);
    build.join(here, doors[door]);
    last = here;
  }
  build.join(last, build.add(VertexKind::deadEnd, {10.4, 0}), {}, {{8.5, 0.2}, {9.5, -0.1}});
  graph.graph = TopologyGraph(std::move(build.vertices), std::move(build.edges));
  return graph;
}

}  // namespace

CRoomGraph sampleGraph() {
  CRoomGraph sample;
  sample.map = sampleMap();
  GraphFile& file = sample.file;
  file.program = "roomgraph";
  file.version = "0.1.0";
  file.input = {"office.gridmap", "gridmap", std::string(64, 'a'), "", sample.map->frame};
  file.options = {{"find_rooms", "min_width", 1.6},
                  {"binarize", "black_threshold", 100},
                  {"room_graph", "straight_edges", false},
                  {"thin_obstacles", "neighbours", std::string("8")}};
  file.graph = sampleRooms();
  file.notes = {{"component_dropped", "A part of the graph was dropped.", {{1.5, 2.5}}},
                {"odd", "Something odd.", std::nullopt}};
  return sample;
}

}  // namespace roomgraph
