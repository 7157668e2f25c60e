#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph export-rawlog`, as Command::declare. */
std::function<int()> exportRawlogCommand(CLI::App& app);

}  // namespace roomgraph
