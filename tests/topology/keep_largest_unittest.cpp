#include "roomgraph/topology/keep_largest.h"

#include <gtest/gtest.h>

#include "hand_built.h"

namespace roomgraph::test {
namespace {

/** Three lines that are not connected, 5, 2 and 0.5 m long. */
TopologyGraph threeLines() {
  return straightWays({{0, 0}, {2, 0}, {0, 10}, {5, 10}, {0, 20}, {0.5, 20}},
                      {{0, 1}, {2, 3}, {4, 5}});
}

TEST(KeepLargest, keepsTheLongestAndTellsOfTheOthers) {
  Notes notes;
  const TopologyGraph kept = keepLargest(threeLines(), {}, notes);
  ASSERT_EQ(kept.edges().size(), 1u);
  EXPECT_DOUBLE_EQ(kept.edges()[0].path.length, 5);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].code, "component_dropped");
  EXPECT_NE(notes[0].text.find("2 parts"), std::string::npos);
  EXPECT_NE(notes[0].text.find("2.5 m"), std::string::npos);
  ASSERT_TRUE(notes[0].where);
  EXPECT_EQ((*notes[0].where)[1], 0);
}

TEST(KeepLargest, keepsAllFromTheLimitUp) {
  Notes notes;
  KeepLargestOptions options;
  options.allComponents = true;
  options.minLength = 1;
  EXPECT_EQ(keepLargest(threeLines(), options, notes).edges().size(), 2u);
  EXPECT_EQ(notes.size(), 1u);
  options.minLength = 0;
  notes.clear();
  EXPECT_EQ(keepLargest(threeLines(), options, notes).edges().size(), 3u);
  EXPECT_TRUE(notes.empty());
}

TEST(KeepLargest, takesTheWidestWhereNoneHasLength) {
  Notes notes;
  const TopologyGraph kept =
      keepLargest({{{{0, 0}, 1, kJunction, {}}, {{5, 0}, 2, kJunction, {}}}, {}}, {}, notes);
  ASSERT_EQ(kept.vertices().size(), 1u);
  EXPECT_EQ(kept.vertices()[0].clearance, 2);
  EXPECT_TRUE(keepLargest({}, {}, notes).vertices().empty());
}

}  // namespace
}  // namespace roomgraph::test
