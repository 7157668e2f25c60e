#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
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

inline std::uint8_t averaged(int red, int green, int blue) {
  return std::uint8_t((red + green + blue + 1) / 3);
}

/** What a pixel that is not opaque shows: unknown lies behind it. */
inline std::uint8_t overBackground(int level, int alpha) {
  constexpr int background = 128;
  return std::uint8_t((level * alpha + background * (255 - alpha) + 127) / 255);
}

}  // namespace roomgraph
