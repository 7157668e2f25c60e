#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace roomgraph {

/** From the top row first, as pictures are stored, to the lowest row first, or back. */
template <class T>
void flipRows(std::vector<T>& cells, std::size_t width) {
  if (width == 0) return;
  const auto row = [&](std::size_t y) { return cells.begin() + std::ptrdiff_t(y * width); };
  for (std::size_t low = 0, high = cells.size() / width; low + 1 < high; ++low)
    std::swap_ranges(row(low), row(low + 1), row(--high));
}

}  // namespace roomgraph
