#include "roomgraph/topology/keep_components.h"

#include <gtest/gtest.h>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

/** Three lines that are not connected, 5, 2 and 0.5 m long. */
TopologyGraph threeLines() {
  return straightWays({{0, 0}, {2, 0}, {0, 10}, {5, 10}, {0, 20}, {0.5, 20}},
                      {{0, 1}, {2, 3}, {4, 5}});
}

RoomId nowhere(Point) { return RoomId::none(); }

TopologyGraph kept(const std::string& which, const RoomAt& roomAt, Notes& notes) {
  return keepComponents(threeLines(), roomAt, {which, 1}, notes);
}

TEST(KeepComponents, keepsTheLongestAndTellsOfTheOthers) {
  for (const char* which : {"largest", "with_rooms"}) {
    Notes notes;
    const TopologyGraph graph = kept(which, nowhere, notes);
    ASSERT_EQ(graph.edges().size(), 1u);
    EXPECT_DOUBLE_EQ(graph.edges()[0].path.length, 5);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].code, "component_dropped");
    EXPECT_NE(notes[0].text.find("2 unconnected parts"), std::string::npos);
    EXPECT_NE(notes[0].text.find("2.5 m"), std::string::npos);
    ASSERT_TRUE(notes[0].where);
    EXPECT_EQ((*notes[0].where)[1], 0);
  }
}

TEST(KeepComponents, keepsThoseThatLeadIntoFurtherRooms) {
  Notes notes;
  const RoomAt ofEachLine = [](Point place) { return RoomId(std::size_t(place.y)); };
  EXPECT_EQ(kept("with_rooms", ofEachLine, notes).edges().size(), 3u);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(kept("largest", ofEachLine, notes).edges().size(), 1u);
  // The longest line and the shortest one lead into one room.
  const RoomAt one = [](Point place) { return place.y == 0 ? RoomId::none() : RoomId(7); };
  EXPECT_EQ(kept("with_rooms", one, notes).edges().size(), 1u);
}

TEST(KeepComponents, keepsAllFromTheLimitUp) {
  Notes notes;
  EXPECT_EQ(kept("all", nowhere, notes).edges().size(), 2u);
  EXPECT_EQ(notes.size(), 1u);
  notes.clear();
  EXPECT_EQ(keepComponents(threeLines(), nowhere, {"all", 0}, notes).edges().size(), 3u);
  EXPECT_TRUE(notes.empty());
}

TEST(KeepComponents, takesTheWidestWhereNoneHasLength) {
  Notes notes;
  const TopologyGraph points({{{0, 0}, 1, kJunction, {}}, {{5, 0}, 2, kJunction, {}}}, {});
  const TopologyGraph graph = keepComponents(points, nowhere, {}, notes);
  ASSERT_EQ(graph.vertices().size(), 1u);
  EXPECT_EQ(graph.vertices()[0].clearance, 2);
  EXPECT_TRUE(keepComponents({}, nowhere, {}, notes).vertices().empty());
}

}  // namespace
}  // namespace roomgraph::test
