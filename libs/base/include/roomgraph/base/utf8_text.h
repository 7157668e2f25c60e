#pragma once
#include <string>

namespace roomgraph {

/** The text as UTF-8: what is not gets a replacement sign. UTF-8 stays as it is. */
[[nodiscard]] std::string utf8Text(const std::string& text);

}  // namespace roomgraph
