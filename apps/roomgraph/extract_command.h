#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph extract`, as Command::declare. */
std::function<int()> extractCommand(CLI::App& app);

}  // namespace roomgraph
