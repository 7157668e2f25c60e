#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** What the program ends with; kStruck where a gate such as --fail-below strikes. */
enum ExitCode { kDone = 0, kBadData = 1, kBadUsage = 2, kStruck = 3 };

/** A subcommand: declares its arguments and returns what to do once they are parsed. That returns
 *  an exit code, and throws UsageError or DataError. */
struct Command {
  const char* name;
  const char* sentence;
  std::function<int()> (*declare)(CLI::App& app);
};

}  // namespace roomgraph
