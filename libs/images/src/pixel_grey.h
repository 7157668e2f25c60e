#pragma once
#include <cstdint>

namespace roomgraph {

inline std::uint8_t averaged(int red, int green, int blue) {
  return std::uint8_t((red + green + blue + 1) / 3);
}

/** What a pixel that is not opaque shows: unknown lies behind it. */
inline std::uint8_t overBackground(int level, int alpha) {
  constexpr int background = 128;
  return std::uint8_t((level * alpha + background * (255 - alpha) + 127) / 255);
}

}  // namespace roomgraph
