#include <gtest/gtest.h>

#include "label_areas.h"

namespace roomgraph {
namespace {

/** A region of 4 x 4 m with its lower left corner at (x, 0). */
Room region(std::uint32_t number, double x) {
  return {{{{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}}, {}}, {x + 2, 2}, 2, number};
}

/** Two rooms with a corridor between them, with openings of 0.5 m clearance; and a second corridor
 *  behind the second room. */
RegionOutlines outlines() {
  RegionOutlines result;
  result.regions = {region(0, 0), region(1, 8), region(2, 4), region(3, 12)};
  result.roomCount = 2;
  result.seenCount = std::uint32_t(result.regions.size());
  result.borders = {{0, 2, {4, 0}, {4, 4}, 0.5},
                    {2, 1, {8, 0}, {8, 4}, 0.5},
                    {1, 3, {12, 0}, {12, 4}, 0.5},
                    {Regions::kNone, 0, {0, 0}, {0, 4}, 0}};
  return result;
}

/** A graph of these rooms of the outlines, each a vertex without edges. */
RoomGraph graphOf(const std::vector<std::uint32_t>& rooms) {
  RoomGraph graph;
  std::vector<Vertex> vertices;
  for (const std::uint32_t room : rooms) {
    const VertexId vertex(vertices.size());
    graph.rooms.push_back({outlines().regions[room], {}, vertex, {}});
    vertices.push_back({outlines().regions[room].widestPlace, 2, VertexKind::room, RoomId(room)});
  }
  graph.graph = TopologyGraph(vertices, {});
  return graph;
}

using Flags = std::vector<std::uint8_t>;

TEST(ReachedRegions, areTheRoomsOfTheGraphAndWhatOpensToThem) {
  EXPECT_EQ(reachedRegions(outlines(), graphOf({0, 1}), 0.3), (Flags{1, 1, 1, 1}));
}

TEST(ReachedRegions, neitherARoomThatIsNotInTheGraphNorWhatLiesBehindIt) {
  EXPECT_EQ(reachedRegions(outlines(), graphOf({0}), 0.3), (Flags{1, 0, 1, 0}));
}

TEST(ReachedRegions, throughOpeningsThatAreWideEnough) {
  EXPECT_EQ(reachedRegions(outlines(), graphOf({0}), 0.5), (Flags{1, 0, 1, 0}));
  EXPECT_EQ(reachedRegions(outlines(), graphOf({0}), 0.6), (Flags{1, 0, 0, 0}));
}

TEST(ReachedRegions, aGraphWithoutRoomsReachesWhereItsVerticesStand) {
  RoomGraph graph;
  graph.graph = TopologyGraph({{{6, 2}, 1, VertexKind::ring, {}}}, {});
  EXPECT_EQ(reachedRegions(outlines(), graph, 0.3), (Flags{0, 0, 1, 0}));
}

TEST(ReachedRegions, noGraphReachesNothing) {
  EXPECT_EQ(reachedRegions(outlines(), {}, 0.3), (Flags{0, 0, 0, 0}));
}

}  // namespace
}  // namespace roomgraph
