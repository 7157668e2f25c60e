#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph config`, as Command::declare. */
std::function<int()> configCommand(CLI::App& app);

}  // namespace roomgraph
