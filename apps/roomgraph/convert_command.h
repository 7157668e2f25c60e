#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph convert`, as Command::declare. */
std::function<int()> convertCommand(CLI::App& app);

}  // namespace roomgraph
