#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph plan`, as Command::declare. */
std::function<int()> planCommand(CLI::App& app);

}  // namespace roomgraph
