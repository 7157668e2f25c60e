#pragma once
#include <string>

namespace roomgraph {

/** A text as a part of XML or HTML, in an element or in quotes: as UTF-8, on one line, with nothing
 *  in it that would be markup. */
[[nodiscard]] std::string xmlText(const std::string& text);

}  // namespace roomgraph
