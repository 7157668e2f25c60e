#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** What the program ends with; kGateFailed where a gate such as --fail-below fails, or there is an
 *  alarm. */
enum ExitCode { kDone = 0, kBadData = 1, kBadUsage = 2, kGateFailed = 3 };

/** A subcommand: declares its arguments and returns what to do once they are parsed. That returns
 *  an exit code, and throws UsageError or DataError. */
struct Command {
  const char* name;
  const char* sentence;
  std::function<int()> (*declare)(CLI::App& app);
};

}  // namespace roomgraph
