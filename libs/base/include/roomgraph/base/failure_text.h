#pragma once
#include <string>

namespace roomgraph {

/** What the user is told of the exception that is being handled: one line without its end. `file`
 *  is put in front of texts that cannot name the file themselves; it may be empty. */
[[nodiscard]] std::string failureText(const std::string& file);

}  // namespace roomgraph
