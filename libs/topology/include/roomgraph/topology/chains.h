#pragma once
#include <cstdint>
#include <functional>
#include <vector>

namespace roomgraph {

/** An edge of a plain graph as two vertex numbers. */
struct Link {
  std::uint32_t source = 0, target = 0;  ///< its ends
};

/** One link in a direction. */
struct Step {
  std::uint32_t link = 0;
  bool isForward = true;
};

/** Runs of links through vertices that have just two ends, from node to node. */
struct Chains {
  std::vector<Step> steps;          ///< of all chains, one after the other
  std::vector<std::size_t> starts;  ///< where each chain starts in `steps`, and one past the last
  std::vector<std::uint32_t> ringNodes;  ///< the node chosen on each closed run that had none

  [[nodiscard]] std::size_t count() const { return starts.size() - 1; }  ///< how many chains
};

/** Splits all links into chains whose inner vertices are no nodes. `isNode` must be true for every
 *  vertex whose number of link ends is not 2. A closed run without a node gets the one of its
 *  vertices that `isBetter(a, b)` puts before all others. Chains are ordered by their first node,
 *  then by link. O(vertices + links). */
[[nodiscard]] Chains findChains(std::size_t vertexCount, const std::vector<Link>& links,
                                std::vector<bool> isNode,
                                const std::function<bool(std::uint32_t, std::uint32_t)>& isBetter);

}  // namespace roomgraph
