#pragma once
#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace roomgraph {

/** Two of several things, the lower index first. */
using PairOfThings = std::pair<std::size_t, std::size_t>;

/** Each two of several things; by the first, then by the other. */
[[nodiscard]] inline std::vector<PairOfThings> pairsOf(std::size_t things) {
  std::vector<PairOfThings> all;
  for (std::size_t a = 0; a < things; ++a)
    for (std::size_t b = a + 1; b < things; ++b) all.emplace_back(a, b);
  return all;
}

/** A value for each two of several things, or for some of these pairs, whichever of both is named
 *  first. There is none of a thing and itself. */
template <class T>
class PairTable {
 public:
  PairTable() = default;
  /** A default value for each pair. */
  explicit PairTable(std::size_t things) : PairTable(things, pairsOf(things)) {}
  /** A default value for each of `pairs`, in any order; none for the others. */
  PairTable(std::size_t things, std::vector<PairOfThings> pairs)
      : pairs_(std::move(pairs)), others_(things), places_(things) {
    for (auto& [a, b] : pairs_)
      if (a > b) std::swap(a, b);
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    // A thing's others are ascending: first those below it, as it is second there.
    for (const bool isSecond : {true, false})
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const auto [a, b] = pairs_[i];
        assert(a < b && b < things);
        others_[isSecond ? b : a].push_back(isSecond ? a : b);
        places_[isSecond ? b : a].push_back(i);
      }
    values_.resize(pairs_.size());
  }

  [[nodiscard]] std::size_t things() const { return others_.size(); }  ///< runs, for instance

  /** Whether there is a value for these two. */
  [[nodiscard]] bool has(std::size_t a, std::size_t b) const {
    return std::binary_search(others_[a].begin(), others_[a].end(), b);
  }

  /** Of two that have one. */
  T& operator()(std::size_t a, std::size_t b) {
    assert(has(a, b));
    return values_[placeOf(a, b)];
  }
  /** Of two that have none a default value. */
  const T& operator()(std::size_t a, std::size_t b) const {
    static const T none{};
    return has(a, b) ? values_[placeOf(a, b)] : none;
  }

  /** Those that have a value, as pairsOf orders them. */
  const std::vector<PairOfThings>& pairs() const { return pairs_; }
  /** Their values, in the same order. */
  const std::vector<T>& values() const { return values_; }
  /** The things with which this one has a value, ascending. */
  const std::vector<std::size_t>& othersOf(std::size_t thing) const { return others_[thing]; }

 private:
  [[nodiscard]] std::size_t placeOf(std::size_t a, std::size_t b) const {
    const auto at = std::lower_bound(others_[a].begin(), others_[a].end(), b);
    return places_[a][std::size_t(at - others_[a].begin())];
  }

  std::vector<PairOfThings> pairs_;
  std::vector<T> values_;
  std::vector<std::vector<std::size_t>> others_, places_;  // by thing
};

/** The same where the order of both counts: what `of` is to `against`. */
template <class T>
class DirectedTable {
 public:
  DirectedTable() = default;
  /** Default values both ways for each of `pairs`. */
  DirectedTable(std::size_t things, std::vector<PairOfThings> pairs)
      : table_(things, std::move(pairs)) {}

  T& operator()(std::size_t of, std::size_t against) { return table_(of, against)[of > against]; }
  const T& operator()(std::size_t of, std::size_t against) const {
    return table_(of, against)[of > against];
  }

  const std::vector<PairOfThings>& pairs() const { return table_.pairs(); }
  const std::vector<std::size_t>& othersOf(std::size_t thing) const {
    return table_.othersOf(thing);
  }

 private:
  PairTable<std::array<T, 2>> table_;
};

}  // namespace roomgraph
