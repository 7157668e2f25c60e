#pragma once
#include <cstdint>
#include <random>

namespace roomgraph {

/** Random whole numbers that are the same on every machine: the standard fixes what std::mt19937
 *  gives, but not what its distributions make of it. */
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  /** 0 to count - 1. */
  int below(int count) { return int((std::uint64_t(engine_()) * std::uint64_t(count)) >> 32); }
  /** low to high, both included. */
  int between(int low, int high) { return low + below(high - low + 1); }
  bool oneIn(int count) { return below(count) == 0; }
  /** About normal, mean 0 and standard deviation 1: the sum of twelve even ones. */
  double normal() {
    constexpr int steps = 1 << 20;
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += (below(steps) + 0.5) / steps;
    return sum;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace roomgraph
