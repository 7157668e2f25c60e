#pragma once
#include <cstddef>
#include <string>

namespace roomgraph::test {

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/** How often it is there. */
inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t place = text.find(part); place != std::string::npos;
       place = text.find(part, place + 1))
    ++found;
  return found;
}

}  // namespace roomgraph::test
