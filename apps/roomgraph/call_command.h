#pragma once
#include <string>

namespace roomgraph {

/** Calls a command of the shell with `input` on its stdin, its stdout going to stderr, and waits
 *  until it ends. Its exit code, 128 and the signal where one ended it, 127 where there is no
 *  shell. */
int callCommand(const std::string& command, const std::string& input);

}  // namespace roomgraph
