#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph collect`, as Command::declare. */
std::function<int()> collectCommand(CLI::App& app);

}  // namespace roomgraph
