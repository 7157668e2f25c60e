#include "roomgraph/repair/CellVotes.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(CellVotes, aBeamPassesAllCellsToItsEnd) {
  const GridFrame frame{10, 10, 0.5, {0, 0}};
  CellVotes votes(frame);
  votes.addBeam({0.25, 0.25}, {2.25, 0.25});
  votes.addBeam({0.25, 0.25}, {4.25, 0.25});
  EXPECT_EQ(votes.seen(frame.index({0, 0})), 2u);
  EXPECT_EQ(votes.wallShare(frame.index({0, 0})), 0);
  EXPECT_EQ(votes.wallShare(frame.index({4, 0})), 0.5);
  EXPECT_EQ(votes.wallShare(frame.index({8, 0})), 1);
  EXPECT_EQ(votes.seen(frame.index({9, 0})), 0u);
  EXPECT_EQ(votes.seen(frame.index({4, 1})), 0u);
}

TEST(CellVotes, aslantAndBackwards) {
  const GridFrame frame{10, 10, 0.5, {0, 0}};
  CellVotes votes(frame);
  votes.addBeam({4.75, 4.75}, {0.25, 0.25});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(votes.seen(frame.index({i, i})), 1u) << i;
  EXPECT_EQ(votes.wallShare(frame.index({0, 0})), 1);
}

}  // namespace
}  // namespace roomgraph
