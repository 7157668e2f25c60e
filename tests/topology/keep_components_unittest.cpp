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

TopologyGraph kept(bool onlyLargest, const RegionAt& regionAt, Notes& notes) {
  return keepComponents(threeLines(), regionAt, {onlyLargest}, notes);
}

TEST(KeepComponents, keepsTheLongestAndTellsOfTheOthers) {
  for (const bool onlyLargest : {true, false}) {
    Notes notes;
    const TopologyGraph graph = kept(onlyLargest, nowhere, notes);
    ASSERT_EQ(graph.edges().size(), 1u);
    EXPECT_DOUBLE_EQ(graph.edges()[0].path.length, 5);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].code, "component_dropped");
    EXPECT_NE(notes[0].text.find("2 parts"), std::string::npos);
    EXPECT_NE(notes[0].text.find("2.5 m"), std::string::npos);
    ASSERT_TRUE(notes[0].where);
    EXPECT_EQ((*notes[0].where)[1], 0);
  }
}

TEST(KeepComponents, keepsThoseThatLeadIntoFurtherRegions) {
  Notes notes;
  const RegionAt ofEachLine = [](Point place) { return RoomId(std::size_t(place.y)); };
  EXPECT_EQ(kept(false, ofEachLine, notes).edges().size(), 3u);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(kept(true, ofEachLine, notes).edges().size(), 1u);
  // The longest line and the shortest one lead into one region.
  const RegionAt one = [](Point place) { return place.y == 0 ? RoomId::none() : RoomId(7); };
  EXPECT_EQ(kept(false, one, notes).edges().size(), 1u);
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
