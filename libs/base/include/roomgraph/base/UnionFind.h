#pragma once
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace roomgraph {

/** Groups of the numbers 0 to n-1 that only ever grow together. */
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /** The smallest number of the group of `i`: it does not depend on the order of joins. */
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /** Returns false where both were in one group already. */
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace roomgraph
