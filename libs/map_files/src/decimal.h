#pragma once
#include <charconv>

namespace roomgraph {

/** What the writer meant where a file keeps single precision: 0.05 is stored as 0.0500000007. */
inline double decimal(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return result;
}

}  // namespace roomgraph
