#include "roomgraph/rooms/find_route.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

Path way(Polyline points, double clearance) {
  Path path;
  path.length = length(points);
  path.points = std::move(points);
  path.minClearance = clearance;
  return path;
}

struct Site {
  RoomGraph graph;
  AreaGraph areas;
};

Polygon box(double left, double right) {
  return {{{left, 0}, {right, 0}, {right, 4}, {left, 4}}, {}};
}

/** Three rooms of 4 x 4 m side by side with doors at (4, 2) and (8, 2), the second one narrow; and
 *  a fourth, which nothing leads to. */
Site threeRooms() {
  Site site;
  for (const double left : {0.0, 4.0, 8.0, 20.0})
    site.areas.areas.push_back({RoomId(site.areas.areas.size()), box(left, left + 4), {}, 2, {}});
  site.areas.passages = {{AreaId(0), AreaId(1), {4, 1.5}, {4, 2.5}, 1},
                         {AreaId(1), AreaId(2), {8, 1.6}, {8, 2.4}, 0.8}};
  const auto vertex = [](double x, VertexKind kind) { return Vertex{{x, 2}, 1, kind, RoomId(0)}; };
  const auto edge = [](std::size_t from, std::size_t to, double a, double b, double clearance) {
    return Edge{VertexId(from), VertexId(to), way({{a, 2}, {b, 2}}, clearance), RoomId(0)};
  };
  site.graph.graph = TopologyGraph(
      {vertex(2, VertexKind::room), vertex(4, VertexKind::border), vertex(6, VertexKind::room),
       vertex(8, VertexKind::border), vertex(10, VertexKind::room), vertex(21, VertexKind::deadEnd),
       vertex(23, VertexKind::deadEnd)},
      {edge(0, 1, 2, 4, 0.5), edge(2, 1, 6, 4, 0.5), edge(2, 3, 6, 8, 0.4), edge(4, 3, 10, 8, 0.4),
       edge(5, 6, 21, 23, 1)});
  return site;
}

std::optional<Route> route(const Site& site, Point from, Point to, double minClearance = 0) {
  return findRoute(site.graph, site.areas, whereIs(site.graph, site.areas, from),
                   whereIs(site.graph, site.areas, to), minClearance);
}

TEST(WhereIs, tellsTheAreaAndTheNearestWayInIt) {
  const Site site = threeRooms();
  const Whereabouts place = whereIs(site.graph, site.areas, {3.9, 3.5});
  EXPECT_EQ(place.area, AreaId(0));
  EXPECT_EQ(place.edge, EdgeId(0));
  EXPECT_NEAR(place.on.x, 3.9, 1e-12);
  EXPECT_FALSE(whereIs(site.graph, site.areas, {15, 15}).area) << "in no area";
}

TEST(WhereIs, fromAClosedAreaNoWayLeads) {
  Site site = threeRooms();
  site.areas.areas.push_back({RoomId(4), box(12, 16), {}, 2, {}});
  EXPECT_EQ(whereIs(site.graph, site.areas, {14, 2}).area, AreaId(4));
  EXPECT_FALSE(whereIs(site.graph, site.areas, {14, 2}).edge);
  EXPECT_FALSE(route(site, {2, 2}, {14, 2}));
  site.areas.passages.push_back({AreaId(4), AreaId::none(), {16, 1.5}, {16, 2.5}, 1});
  EXPECT_FALSE(whereIs(site.graph, site.areas, {14, 2}).edge) << "beams go out of a window";
  site.areas.passages.push_back({AreaId(2), AreaId(4), {12, 1.5}, {12, 2.5}, 1});
  EXPECT_TRUE(route(site, {2, 2}, {14, 2})) << "a nook without ways of its own";
}

TEST(WhereIs, doesNotTakeAWayBehindAWall) {
  Site site = threeRooms();
  site.areas.areas[1].polygon = box(4.5, 8);
  EXPECT_EQ(whereIs(site.graph, site.areas, {4.6, 2}).edge, EdgeId(1));
  EXPECT_GE(whereIs(site.graph, site.areas, {4.6, 2}).on.x, 4.5);
}

TEST(FindRoute, goesThroughTheDoorsAndTellsHowNarrowItIs) {
  const auto found = route(threeRooms(), {2, 2}, {9, 3});
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->length, 8) << "with the last metre, beside the ways";
  EXPECT_DOUBLE_EQ(found->besideWays, 1);
  EXPECT_DOUBLE_EQ(found->minClearance, 0.4);
  EXPECT_EQ(found->passages, (std::vector<PassageId>{PassageId(0), PassageId(1)}));
  EXPECT_EQ(found->points.front(), (Point{2, 2}));
  EXPECT_EQ(found->points.back(), (Point{9, 3}));
}

TEST(FindRoute, isNeverShorterThanTheStraightLine) {
  const Site site = threeRooms();
  for (const Point to : {Point{2, 3.9}, Point{2.2, 0.1}, Point{11, 3.5}, Point{7, 0.5}}) {
    const auto found = route(site, {2, 1}, to);
    ASSERT_TRUE(found);
    EXPECT_GE(found->length, distance({2, 1}, to) - 1e-12);
    EXPECT_NEAR(found->length, length(found->points), 1e-12);
  }
}

TEST(FindRoute, isTheSameBackwards) {
  const auto there = route(threeRooms(), {3, 2}, {9, 2}),
             back = route(threeRooms(), {9, 2}, {3, 2});
  ASSERT_TRUE(there && back);
  EXPECT_DOUBLE_EQ(there->length, back->length);
  EXPECT_EQ(back->passages.front(), PassageId(1));
}

TEST(FindRoute, alongOneWayIsAPieceOfIt) {
  const auto found = route(threeRooms(), {3.5, 2}, {2.5, 2});
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->length, 1);
  EXPECT_TRUE(found->passages.empty());
}

TEST(FindRoute, ofOnePlaceOfAWayTellsHowNarrowThatIs) {
  const auto found = route(threeRooms(), {3, 1}, {3, 3});
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->length, 2);
  EXPECT_DOUBLE_EQ(found->minClearance, 0.5);
}

TEST(FindRoute, goesNoWayThatIsTooNarrow) {
  EXPECT_TRUE(route(threeRooms(), {2, 2}, {9, 2}, 0.4));
  EXPECT_FALSE(route(threeRooms(), {2, 2}, {9, 2}, 0.41));
  EXPECT_FALSE(route(threeRooms(), {9, 2}, {2, 2}, 0.41));
  EXPECT_FALSE(route(threeRooms(), {3, 2}, {2.5, 2}, 0.51)) << "along one way";
  Site site = threeRooms();
  std::vector<Edge> edges = site.graph.graph.edges();
  Edge round = edges[2];
  round.path = way({{6, 2}, {7, 3.5}, {8, 2}}, 0.6);
  edges.push_back(round);
  site.graph.graph = TopologyGraph(site.graph.graph.vertices(), edges);
  EXPECT_NEAR(route(site, {5, 2}, {8, 2}, 0.5)->length, 1 + round.path.length, 1e-9);
}

TEST(FindRoute, isNoneToWhatIsNotConnected) {
  EXPECT_FALSE(route(threeRooms(), {2, 2}, {22, 2}));
  EXPECT_FALSE(route({}, {2, 2}, {3, 2}));
}

}  // namespace
}  // namespace roomgraph
