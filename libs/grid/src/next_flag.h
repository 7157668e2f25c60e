#pragma once
#include <cstdint>
#include <cstring>

namespace roomgraph {

/** The first flag of a row that is 1, not before `from`; `width` where there is none. Faster than
 *  looking at each, as most are 0. */
inline int nextFlag(const std::uint8_t* row, int width, int from) {
  const void* found = std::memchr(row + from, 1, std::size_t(width - from));
  return found ? int(static_cast<const std::uint8_t*>(found) - row) : width;
}

}  // namespace roomgraph
