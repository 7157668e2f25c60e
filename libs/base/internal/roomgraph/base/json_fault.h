#pragma once
#include <string>

namespace roomgraph {

/** Why the text cannot be a whole JSON object of this format, such as "roomgraph/graph"; empty
 *  where it can. Looks at ends, nesting and the format's name only, so that a foreign or damaged
 *  file is refused before a parser takes twenty times its size in memory. O(bytes). */
std::string jsonFault(const std::string& text, const std::string& format);

}  // namespace roomgraph
