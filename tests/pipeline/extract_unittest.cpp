#include "roomgraph/pipeline/extract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <thread>

#include "MapText.h"
#include "brute_force.h"
#include "random_maps.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/rooms/find_rooms.h"
#include "roomgraph/rooms/trace_rooms.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph::test {
namespace {

void write(const Point& p, std::ostream& out) { out << p.x << ' ' << p.y << ' '; }

/** Every number of the result, to the last bit. */
std::string bytesOf(const RoomGraph& result) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Vertex& v : result.graph.vertices()) {
    write(v.place, out);
    out << v.clearance << ' ' << int(v.kind) << ' ' << (v.room ? int(v.room.index()) : -1) << '\n';
  }
  for (const Edge& e : result.graph.edges()) {
    out << e.source.index() << ' ' << e.target.index() << ' ' << e.path.length << ' '
        << e.path.minClearance << ' ';
    for (const Point p : e.path.points) write(p, out);
    out << (e.room ? int(e.room.index()) : -1) << '\n';
  }
  for (const GraphRoom& room : result.rooms) {
    write(room.center, out);
    out << room.shape.inscribedRadius << ' ';
    for (const Point p : room.shape.polygon.outer) write(p, out);
    for (const Ring& hole : room.shape.polygon.holes)
      for (const Point p : hole) write(p, out);
    for (const VertexId v : room.borderVertices) out << v.index() << ' ';
    out << '\n';
  }
  return out.str();
}

TEST(Extract, givesTheSameBytesTwice) {
  const GreyMap map = greyMap(noisyOffice(7, 300));
  const std::string first = bytesOf(extract(map, {}).result);
  EXPECT_GT(first.size(), 10000u);
  EXPECT_EQ(first, bytesOf(extract(map, {}).result));
}

TEST(Extract, givesTheSameGraphWithoutTheDiagram) {
  const GreyMap map = greyMap(noisyOffice(7, 200));
  const Stages stages = extractGraph(map, {});
  EXPECT_TRUE(stages.voronoi.edges.empty());
  EXPECT_EQ(bytesOf(stages.result), bytesOf(extract(map, {}).result));
  EXPECT_EQ(stages.source.sha256, map.source.sha256);
}

TEST(Extract, givesTheSameBytesOnSeveralThreads) {
  std::vector<GreyMap> maps;
  std::vector<std::string> alone, together(8);
  for (unsigned seed = 0; seed < 4; ++seed) {
    maps.push_back(greyMap(noisyOffice(seed, 260)));
    alone.push_back(bytesOf(extract(maps.back(), {}).result));
  }
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < together.size(); ++i)
    threads.emplace_back([&, i] { together[i] = bytesOf(extract(maps[i % 4], {}).result); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < together.size(); ++i) EXPECT_EQ(together[i], alone[i % 4]) << i;
}

/** The rooms as sets of corners: the same for any order of rooms and any start of a ring. */
std::vector<std::vector<Point>> cornersOf(const Rooms& rooms) {
  std::vector<std::vector<Point>> all;
  for (const Room& room : rooms) {
    std::vector<Point> corners = room.polygon.outer;
    for (const Ring& hole : room.polygon.holes)
      corners.insert(corners.end(), hole.begin(), hole.end());
    std::sort(corners.begin(), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(ExtractAgain, givesWhatExtractGives) {
  std::size_t changed = 0;
  for (const std::string& name : mapNames()) {
    const MapText text = readMapText(name);
    const GreyMap map = greyMap(text);
    const ExtractOptions first = optionsOf(text);
    ExtractOptions other = first;
    other.findRooms.minWidth = 2 * text.resolution, other.findRooms.alphaPx2 = 0;
    other.clearClutter.maxSize = 0, other.keepClear.minClearance = 0.5 * text.resolution;
    const Stages before = extract(map, first), again = extractAgain(before, map, other);
    const Stages anew = extract(map, other);
    EXPECT_EQ(bytesOf(again.result), bytesOf(anew.result)) << name;
    EXPECT_EQ(again.notes.size(), anew.notes.size()) << name;
    EXPECT_EQ(bytesOf(extractAgain(again, map, first).result), bytesOf(before.result)) << name;
    changed += bytesOf(again.result) != bytesOf(before.result);
  }
  EXPECT_GT(changed, 5u) << "or the options make no difference";
}

TEST(Extract, findsTheSameRoomsWhateverTheOrderOfTheObstacles) {
  ExtractOptions options;
  options.findRooms.minWidth = 1.63;  // no multiple of a cell: no ties
  options.clearClutter.maxSize = 0;
  const Stages stages = extract(greyMap(noisyOffice(5, 300)), options);
  ASSERT_GT(stages.rooms.size(), 2u);
  ObstacleCells shuffled = stages.obstacles;
  std::mt19937 random(11);
  for (std::size_t i = shuffled.cells.size(); i > 1; --i)
    std::swap(shuffled.cells[i - 1], shuffled.cells[random() % i]);
  const VoronoiGraph voronoi = voronoiGraph(shuffled);
  const InsideFlags isInside = keepInside(voronoi, stages.grid, stages.options.keepInside);
  const Regions regions = findRooms(voronoi, isInside, stages.roomRadius, 0);
  Rooms rooms = traceRegions(voronoi, regions);
  rooms.resize(regions.roomCount);
  EXPECT_EQ(cornersOf(rooms), cornersOf(stages.rooms));
}

/** Walls round the cells from `low` to `high`, and free space within. */
void drawRoom(std::vector<std::string>& rows, Cell low, Cell high) {
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x)
      rows[std::size_t(y)][std::size_t(x)] =
          y == low.y || y == high.y || x == low.x || x == high.x ? '#' : '.';
}

/** What beams saw to the right through a gap, at first 2 * `half` cells wide. */
void drawFan(std::vector<std::string>& rows, Cell gap, int half, int end) {
  for (int x = gap.x; x < end; ++x) {
    const int reach = half + (x - gap.x) / 5;
    for (int y = gap.y - reach; y < gap.y + reach; ++y) rows[std::size_t(y)][std::size_t(x)] = '.';
    rows[std::size_t(gap.y - reach - 2)][std::size_t(x)] = '.';  // one more beam, on its own
  }
}

/** A room with a gap of 1 m in its right wall, through which beams went far out. */
GreyMap roomWithAFan() {
  std::vector<std::string> rows(60, std::string(140, '?'));
  drawRoom(rows, {5, 5}, {54, 54});
  for (int y = 25; y < 35; ++y) rows[std::size_t(y)][54] = '.';
  drawFan(rows, {55, 30}, 5, 135);
  return greyMap(drawn(rows, 0.1));
}

TEST(Extract, leavesFansOfBeamsOut) {
  const Stages stages = extract(roomWithAFan(), {});
  ASSERT_EQ(stages.areas.areas.size(), 1u);
  EXPECT_TRUE(stages.areas.areas[0].isRoom());
  for (const Vertex& vertex : stages.result.graph.vertices()) EXPECT_LT(vertex.place.x, 6);
  const auto isHalfSeen = [](const Note& note) { return note.code == "half_seen"; };
  EXPECT_EQ(std::count_if(stages.notes.begin(), stages.notes.end(), isHalfSeen), 1);
}

/** A long kitchen with one door is a room; with two ways out it would be a corridor. */
TEST(Extract, aWindowIsNoWayOut) {
  std::vector<std::string> rows(60, std::string(180, '?'));
  drawRoom(rows, {5, 5}, {54, 54});
  drawRoom(rows, {54, 21}, {118, 38});
  for (int y = 26; y < 34; ++y) rows[std::size_t(y)][54] = '.';
  EXPECT_EQ(extract(greyMap(drawn(rows, 0.1)), {}).result.rooms.size(), 2u);
  for (int y = 27; y < 33; ++y) rows[std::size_t(y)][118] = '.';
  drawFan(rows, {119, 30}, 3, 175);
  EXPECT_EQ(extract(greyMap(drawn(rows, 0.1)), {}).result.rooms.size(), 2u);
}

/** What single beams saw behind a wall: many pieces, and none of any size. */
TEST(Extract, saysNothingOfSingleBeams) {
  std::vector<std::string> rows(60, std::string(140, '?'));
  drawRoom(rows, {5, 5}, {54, 54});
  for (int y = 5; y < 55; ++y) {
    std::string& row = rows[std::size_t(y)];
    if (y % 5 < 2) std::fill(row.begin() + 60, row.begin() + 80, '.');
  }
  const Stages stages = extract(greyMap(drawn(rows, 0.1)), {});
  EXPECT_FALSE(stages.outlines.halfSeen().empty());
  for (const Note& note : stages.notes) EXPECT_NE(note.code, "half_seen") << note.text;
}

TEST(Extract, keepsTheStagesInTheOrderOfThePaper) {
  const Stages stages = extract(greyMap(randomMap(3, 60, 40, 0.1)), {});
  std::vector<std::string> names;
  for (const StageTiming& timing : stages.timings) names.push_back(timing.stage);
  const std::vector<std::string> expected{
      "binarize",        "obstacle_cells", "voronoi_graph",   "keep_inside",    "clear_clutter",
      "region_outlines", "keep_clear",     "drop_half_seen",  "topology_graph", "dead_ends",
      "pass_clutter",    "join_vertices",  "keep_components", "trace_rooms",    "border_vertices",
      "cut_paths",       "room_ids",       "short_dead_ends", "join_doors",     "room_graph",
      "area_graph"};
  EXPECT_EQ(names, expected);
  EXPECT_EQ(stages.stretches.size(), stages.kept.edges().size());
  EXPECT_EQ(stages.isInside.size(), stages.voronoi.vertices.size());
}

TEST(Extract, findsNoRoomNarrowerThanAPath) {
  ExtractOptions options;
  options.findRooms.minWidth = 0.1;
  const Stages stages = extract(greyMap(randomMap(3, 60, 40, 0.1)), options);
  EXPECT_EQ(stages.roomRadius, stages.clearance);
}

TEST(Extract, passesTheNotesOfTheMapOn) {
  GreyMap map = greyMap(drawn({"..."}, 0.1));
  map.notes.push_back({"odd", "an odd map", std::nullopt});
  const Stages stages = extract(map, {});
  ASSERT_FALSE(stages.notes.empty());
  EXPECT_EQ(stages.notes.front().code, "odd");
}

/** A hall of 24 x 13 m with a door below, and three shelves of 1 x 8 m with aisles of 5 to 6 m. */
MapText warehouse() {
  MapText map = painted(240, 140, 0.1, {});
  const auto fill = [&](int left, int low, int width, int height, char cell) {
    for (int y = low; y < low + height; ++y)
      for (int x = left; x < left + width; ++x) map.cells[std::size_t(y * 240 + x)] = cell;
  };
  for (const int left : {50, 110, 170}) fill(left, 45, 10, 80, '#');
  fill(0, 6, 240, 2, '#');
  fill(100, 6, 10, 2, '.');
  return map;
}

/** To the nearest way inside of a room [m]. */
double distanceToWays(const Stages& stages, Point place) {
  double nearest = 1e9;
  for (const Edge& edge : stages.result.graph.edges())
    for (std::size_t i = 0; edge.room && i + 1 < edge.path.points.size(); ++i)
      nearest =
          std::min(nearest, distanceToSegment(place, edge.path.points[i], edge.path.points[i + 1]));
  return nearest;
}

TEST(Extract, leadsThroughTheAislesOfAHall) {
  const Stages stages = extract(greyMap(warehouse()), {});
  for (const double x : {2.5, 8.5, 14.5, 21.0})
    for (const double y : {5.0, 8.0, 11.0})
      EXPECT_LT(distanceToWays(stages, {x, y}), 1) << x << ", " << y;
}

TEST(Extract, leadsNoRobotThroughAnAisleThatIsTooNarrow) {
  ExtractOptions options;
  options.roomGraph.robotWidth = 6;
  const Stages stages = extract(greyMap(warehouse()), options);
  EXPECT_GT(distanceToWays(stages, {21.0, 11.0}), 2);
}

/** A hall of 9.8 x 7.8 m with twelve pillars of 0.4 m, not quite in rows, and a door of so many
 *  cells to a room. */
MapText pillars(int door) {
  MapText map = painted(140, 80, 0.1, {});
  const auto paint = [&](int x, int y, char cell) { map.cells[std::size_t(y * 140 + x)] = cell; };
  for (int x = 18; x < 90; x += 20)
    for (int y = 18; y < 70; y += 20)
      for (int i = 0; i < 16; ++i) paint(x + i / 4 + y % 3, y + i % 4 + x / 20, '#');
  for (int y = 0; y < 80; ++y) paint(99, y, '#');
  for (int y = 37; y < 37 + door; ++y) paint(99, y, '.');
  return map;
}

TEST(Extract, leadsRoundPillarsOnlyWhereNoDoorLeadsOut) {
  for (const auto& [door, rings] : {std::pair(0, 12U), std::pair(9, 1U)}) {
    const TopologyGraph graph = extract(greyMap(pillars(door)), {}).result.graph;
    EXPECT_EQ(graph.edges().size() + componentCount(graph) - graph.vertices().size(), rings)
        << door;
  }
}

TEST(Extract, keepsThePapersStarInAHallWithAisles) {
  const Stages stages = extract(greyMap(warehouse()), preset("paper"));
  for (const GraphRoom& room : stages.result.rooms)
    EXPECT_EQ(stages.result.graph.degree(room.vertex), room.borderVertices.size());
}

}  // namespace
}  // namespace roomgraph::test
