#include "roomgraph/base/OneToOne.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(OneToOne, eachThingIsInOnePairAtMost) {
  OneToOne pairing(2, 3);
  EXPECT_TRUE(pairing.take(0, 2));
  EXPECT_FALSE(pairing.take(0, 1)) << "the first is taken";
  EXPECT_FALSE(pairing.take(1, 2)) << "the second is taken";
  EXPECT_TRUE(pairing.take(1, 1)) << "what was refused takes nothing";
}

}  // namespace
}  // namespace roomgraph
