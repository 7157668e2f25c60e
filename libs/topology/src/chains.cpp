#include "roomgraph/topology/chains.h"

namespace roomgraph {
namespace {

class ChainFinder {
 public:
  ChainFinder(std::size_t vertexCount, const std::vector<Link>& links, std::vector<bool>& isNode)
      : links_(links), isNode_(isNode), firstEnd_(vertexCount + 1), isUsed_(links.size()) {
    for (const Link& link : links) {
      ++firstEnd_[link.source + 1];
      ++firstEnd_[link.target + 1];
    }
    for (std::size_t v = 0; v < vertexCount; ++v) firstEnd_[v + 1] += firstEnd_[v];
    ends_.resize(2 * links.size());
    auto next = firstEnd_;
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      ends_[next[links[i].source]++] = i;
      ends_[next[links[i].target]++] = i;
    }
  }

  /** Every unused chain that leaves `node`. */
  void walkFrom(std::uint32_t node, Chains& chains) {
    for (auto end = firstEnd_[node]; end < firstEnd_[node + 1]; ++end)
      if (!isUsed_[ends_[end]]) walk(node, ends_[end], chains);
  }

  bool isUsed(std::uint32_t link) const { return isUsed_[link]; }

  /** The vertices of the closed run through `link`, starting with the link's source. */
  std::vector<std::uint32_t> cycleThrough(std::uint32_t link) const {
    const std::uint32_t first = links_[link].source;
    std::vector<std::uint32_t> cycle{first};
    for (auto at = links_[link].target; at != first; at = opposite(link, at)) {
      cycle.push_back(at);
      link = otherLink(at, link);
    }
    return cycle;
  }

 private:
  void walk(std::uint32_t at, std::uint32_t link, Chains& chains) {
    while (true) {
      isUsed_[link] = true;
      chains.steps.push_back({link, links_[link].source == at});
      at = opposite(link, at);
      if (isNode_[at]) break;
      link = otherLink(at, link);
    }
    chains.starts.push_back(chains.steps.size());
  }

  std::uint32_t opposite(std::uint32_t link, std::uint32_t v) const {
    return links_[link].source == v ? links_[link].target : links_[link].source;
  }
  std::uint32_t otherLink(std::uint32_t v, std::uint32_t link) const {
    const auto first = firstEnd_[v];
    return ends_[first] == link ? ends_[first + 1] : ends_[first];
  }

  const std::vector<Link>& links_;
  const std::vector<bool>& isNode_;
  std::vector<std::uint32_t> firstEnd_;  // per vertex into ends_
  std::vector<std::uint32_t> ends_;      // links by the vertices they end at
  std::vector<bool> isUsed_;
};

}  // namespace

Chains findChains(std::size_t vertexCount, const std::vector<Link>& links, std::vector<bool> isNode,
                  const std::function<bool(std::uint32_t, std::uint32_t)>& isBetter) {
  Chains chains;
  chains.starts.push_back(0);
  ChainFinder finder(vertexCount, links, isNode);
  for (std::uint32_t v = 0; v < vertexCount; ++v)
    if (isNode[v]) finder.walkFrom(v, chains);
  for (std::uint32_t link = 0; link < links.size(); ++link) {
    if (finder.isUsed(link)) continue;
    const auto cycle = finder.cycleThrough(link);
    std::uint32_t best = cycle.front();
    for (const auto v : cycle)
      if (isBetter(v, best)) best = v;
    isNode[best] = true;
    chains.ringNodes.push_back(best);
    finder.walkFrom(best, chains);
  }
  return chains;
}

}  // namespace roomgraph
