#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace roomgraph {

/** Groups of the numbers 0 to n-1 that only ever grow together. */
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /** The smallest number of the group of `i`: it does not depend on the order of joins. */
  std::uint32_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return std::uint32_t(i);
  }

  /** Returns false where both were in one group already. */
  bool join(std::size_t i, std::size_t j) {
    const auto [a, b] = std::minmax({find(i), find(j)});
    parent_[b] = a;
    return a < b;
  }

  /** The members of each group in ascending order; the groups by their smallest ones. */
  std::vector<std::vector<std::size_t>> sets() {
    std::vector<std::vector<std::size_t>> sets(parent_.size());
    for (std::size_t i = 0; i < sets.size(); ++i) sets[find(i)].push_back(i);
    sets.erase(std::remove(sets.begin(), sets.end(), std::vector<std::size_t>()), sets.end());
    return sets;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace roomgraph
