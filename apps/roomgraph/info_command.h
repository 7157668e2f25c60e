#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph info`, as Command::declare. */
std::function<int()> infoCommand(CLI::App& app);

}  // namespace roomgraph
