#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph repair`, as Command::declare. */
std::function<int()> repairCommand(CLI::App& app);

}  // namespace roomgraph
