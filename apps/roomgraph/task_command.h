#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph task`, as Command::declare. */
std::function<int()> taskCommand(CLI::App& app);

}  // namespace roomgraph
