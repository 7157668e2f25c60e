#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph route`, as Command::declare. */
std::function<int()> routeCommand(CLI::App& app);

}  // namespace roomgraph
