#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph merge`, as Command::declare. */
std::function<int()> mergeCommand(CLI::App& app);

}  // namespace roomgraph
