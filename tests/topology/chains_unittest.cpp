#include "roomgraph/topology/chains.h"

#include <gtest/gtest.h>

namespace roomgraph::test {
namespace {

/** The links of each chain, with a minus where one is walked backwards. */
std::vector<std::string> walked(const Chains& chains) {
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < chains.count(); ++c) {
    texts.emplace_back();
    for (std::size_t s = chains.starts[c]; s < chains.starts[c + 1]; ++s)
      texts.back() +=
          (chains.steps[s].isForward ? "+" : "-") + std::to_string(chains.steps[s].link);
  }
  return texts;
}

TEST(Chains, aClosedRunGetsItsBestVertex) {
  const std::vector<Link> links{{0, 1}, {1, 2}, {2, 0}};
  const Chains chains = findChains(3, links, {false, false, false},
                                   [](std::uint32_t a, std::uint32_t b) { return a > b; });
  EXPECT_EQ(chains.ringNodes, std::vector<std::uint32_t>{2});
  EXPECT_EQ(chains.count(), 1u);
  EXPECT_EQ(chains.steps.size(), 3u);
}

TEST(Chains, aLinkFromAVertexToItselfIsAChain) {
  const Chains chains =
      findChains(1, {{0, 0}}, {false}, [](std::uint32_t a, std::uint32_t b) { return a < b; });
  EXPECT_EQ(chains.ringNodes, std::vector<std::uint32_t>{0});
  EXPECT_EQ(chains.count(), 1u);
}

TEST(Chains, runFromNodeToNode) {
  // 0 - 1 - 2 - 3, with a branch from 2 to 4; links point either way.
  const Chains chains = findChains(5, {{0, 1}, {2, 1}, {2, 3}, {4, 2}},
                                   {true, false, true, true, true}, std::less<>());
  EXPECT_EQ(walked(chains), (std::vector<std::string>{"+0-1", "+2", "-3"}));
  EXPECT_TRUE(chains.ringNodes.empty());
}

TEST(Chains, ofNothingThereIsNone) {
  EXPECT_EQ(findChains(0, {}, {}, std::less<>()).count(), 0u);
  EXPECT_EQ(findChains(2, {}, {true, true}, std::less<>()).count(), 0u);
}

}  // namespace
}  // namespace roomgraph::test
