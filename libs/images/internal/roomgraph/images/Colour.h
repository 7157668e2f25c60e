#pragma once
#include <cstdint>

namespace roomgraph {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
};

}  // namespace roomgraph
