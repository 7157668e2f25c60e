#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph archive`, as Command::declare. */
std::function<int()> archiveCommand(CLI::App& app);

}  // namespace roomgraph
