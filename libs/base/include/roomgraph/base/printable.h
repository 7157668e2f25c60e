#pragma once
#include <string>

namespace roomgraph {

/** The text as one line that is safe to show: all that would steer a terminal or turn the order of
 *  the letters (control characters, line ends, marks of direction) and all that is no UTF-8 is a
 *  '?' each. File names may hold anything. */
[[nodiscard]] std::string printable(const std::string& text);

}  // namespace roomgraph
