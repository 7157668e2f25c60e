#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph stability`, as Command::declare. */
std::function<int()> stabilityCommand(CLI::App& app);

}  // namespace roomgraph
