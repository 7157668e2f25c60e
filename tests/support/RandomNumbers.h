#pragma once
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph::test {

/** Random numbers for tests, the same for the same seed on every machine: the standard fixes what
 *  std::mt19937 gives, but not what its distributions make of it. */
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (double(engine_()) / 4294967296.0);
  }
  /** 0 to count - 1. */
  std::size_t below(std::size_t count) {
    return std::size_t((std::uint64_t(engine_()) * std::uint64_t(count)) >> 32);
  }
  Point place(double reach) { return {between(-reach, reach), between(-reach, reach)}; }
  /** Any turn, and a shift of up to `reach`. */
  Transform2D pose(double reach) {
    const Point at = place(reach);
    return {at.x, at.y, between(-M_PI, M_PI)};
  }
  template <class T>
  void shuffle(std::vector<T>& things) {
    for (std::size_t i = things.size(); i > 1; --i) std::swap(things[i - 1], things[below(i)]);
  }

 private:
  std::mt19937 engine_;
};

}  // namespace roomgraph::test
