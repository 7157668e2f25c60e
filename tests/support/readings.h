#pragma once
#include <cstddef>

namespace roomgraph::test {

/** What the program has been at since the test set it to {}. */
struct Readings {
  std::size_t files = 0;   ///< opened and inflated
  std::size_t scans = 0;   ///< 2D scans decoded
  std::size_t clouds = 0;  ///< arrays of points decoded
};
extern Readings readings;

}  // namespace roomgraph::test
