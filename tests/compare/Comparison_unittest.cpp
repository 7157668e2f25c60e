#include "roomgraph/compare/Comparison.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

ComparedPair pairOf(const std::string& a, const std::string& b, double confidence) {
  ComparedPair pair;
  pair.a = a, pair.b = b, pair.isSameSite = true, pair.confidence = confidence;
  return pair;
}

TEST(Comparison, aPlaceIsDoubtfulIfMostPairsAre) {
  Comparison comparison;
  EXPECT_FALSE(comparison.isPlaceDoubtful("a")) << "nothing speaks against it";
  comparison.pairs = {pairOf("a", "b", 0.99), pairOf("a", "c", 0.3), pairOf("b", "c", 0.4)};
  EXPECT_FALSE(comparison.isPlaceDoubtful("a")) << "one of two";
  EXPECT_TRUE(comparison.isPlaceDoubtful("c"));
  comparison.pairs[2].isSameSite = false;
  EXPECT_TRUE(comparison.isPlaceDoubtful("c")) << "the other one still is";
  comparison.pairs[1].isSameSite = false;
  EXPECT_FALSE(comparison.isPlaceDoubtful("c")) << "those of other sites do not count";
}

}  // namespace
}  // namespace roomgraph
