#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph compare`, as Command::declare. */
std::function<int()> compareCommand(CLI::App& app);

}  // namespace roomgraph
