#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph carry`, as Command::declare. */
std::function<int()> carryCommand(CLI::App& app);

}  // namespace roomgraph
