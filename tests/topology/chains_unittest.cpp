#include "roomgraph/topology/chains.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "RandomNumbers.h"

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

TEST(Chains, useEachLinkOnceAndStopAtNodesOnly) {
  RandomNumbers random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = 1 + random.below(12);
    std::vector<Link> links;
    for (std::size_t i = random.below(20); i > 0; --i)
      links.push_back({std::uint32_t(random.below(count)), std::uint32_t(random.below(count))});
    std::vector<std::size_t> ends(count);
    for (const Link& link : links) ++ends[link.source], ++ends[link.target];
    std::vector<bool> isNode;
    for (const std::size_t of : ends) isNode.push_back(of != 2);
    const Chains chains = findChains(count, links, isNode, std::less<>());
    for (const std::uint32_t v : chains.ringNodes) {
      EXPECT_FALSE(isNode[v]) << "it had two ends";
      isNode[v] = true;
    }
    std::vector<int> uses(links.size());
    const auto from = [&](const Step& step) {
      return step.isForward ? links[step.link].source : links[step.link].target;
    };
    const auto to = [&](const Step& step) { return from({step.link, !step.isForward}); };
    for (std::size_t c = 0; c < chains.count(); ++c) {
      ASSERT_LT(chains.starts[c], chains.starts[c + 1]) << "no chain is empty";
      EXPECT_TRUE(isNode[from(chains.steps[chains.starts[c]])]);
      EXPECT_TRUE(isNode[to(chains.steps[chains.starts[c + 1] - 1])]);
      for (std::size_t s = chains.starts[c]; s < chains.starts[c + 1]; ++s) {
        ++uses[chains.steps[s].link];
        if (s == chains.starts[c]) continue;
        EXPECT_EQ(from(chains.steps[s]), to(chains.steps[s - 1]));
        EXPECT_FALSE(isNode[from(chains.steps[s])]);
      }
    }
    EXPECT_EQ(uses, std::vector<int>(links.size(), 1)) << trial;
  }
}

}  // namespace
}  // namespace roomgraph::test
