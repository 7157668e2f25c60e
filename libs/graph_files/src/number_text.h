#pragma once
#include <charconv>
#include <string>

namespace roomgraph {

/** The shortest text that reads back equal; the same in every locale. */
inline std::string numberText(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

}  // namespace roomgraph
