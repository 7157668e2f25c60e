#pragma once
#include <string>

namespace roomgraph {

/** "roomgraph: text" and a line end; one printable line. */
std::string errorLine(const std::string& text);

/** What the user is told of an exception. */
struct Failure {
  std::string line;  ///< with its line end
  int exitCode = 0;
};

/** The exception that is being handled, as one line. `file` is put in front of messages that do not
 *  name the file themselves. */
Failure currentFailure(const std::string& file);

}  // namespace roomgraph
