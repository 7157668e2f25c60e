#pragma once
#include <cstddef>
#include <functional>

namespace roomgraph {

/** Calls job(0) to job(count - 1), in any order, on any threads. Jobs do not throw. */
using ForEach = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/** A ForEach on this thread alone, in order. */
inline void oneByOne(std::size_t count, const std::function<void(std::size_t)>& job) {
  for (std::size_t i = 0; i < count; ++i) job(i);
}

}  // namespace roomgraph
