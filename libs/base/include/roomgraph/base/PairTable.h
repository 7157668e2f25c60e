#pragma once
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace roomgraph {

/** Each two of several things, the lower index first; by that, then by the other. */
inline std::vector<std::pair<std::size_t, std::size_t>> pairsOf(std::size_t things) {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t a = 0; a < things; ++a)
    for (std::size_t b = a + 1; b < things; ++b) all.emplace_back(a, b);
  return all;
}

/** A value for each two of several things, whichever of them is named first. There is none of a
 *  thing and itself. */
template <class T>
class PairTable {
 public:
  PairTable() = default;
  /** A default value for each pair. */
  explicit PairTable(std::size_t things)
      : things_(things), values_(things < 2 ? 0 : things * (things - 1) / 2) {}

  std::size_t things() const { return things_; }

  T& operator()(std::size_t a, std::size_t b) { return values_[indexOf(a, b)]; }
  const T& operator()(std::size_t a, std::size_t b) const { return values_[indexOf(a, b)]; }

  std::vector<std::pair<std::size_t, std::size_t>> pairs() const { return pairsOf(things_); }
  /** All values, in the order of pairs(). */
  const std::vector<T>& values() const { return values_; }

 private:
  std::size_t indexOf(std::size_t a, std::size_t b) const {
    if (a > b) std::swap(a, b);
    assert(a < b && b < things_);
    return a * things_ - a * (a + 1) / 2 + b - a - 1;
  }

  std::size_t things_ = 0;
  std::vector<T> values_;
};

/** A value for each two of several things where the order counts: what `of` is to `against`. That
 *  of a thing and itself is there, too. */
template <class T>
class DirectedTable {
 public:
  DirectedTable() = default;
  /** A default value for each. */
  explicit DirectedTable(std::size_t things) : things_(things), values_(things * things) {}

  std::size_t things() const { return things_; }

  T& operator()(std::size_t of, std::size_t against) { return values_[of * things_ + against]; }
  const T& operator()(std::size_t of, std::size_t against) const {
    return values_[of * things_ + against];
  }

 private:
  std::size_t things_ = 0;
  std::vector<T> values_;
};

}  // namespace roomgraph
