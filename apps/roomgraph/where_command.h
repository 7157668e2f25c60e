#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph where`, as Command::declare. */
std::function<int()> whereCommand(CLI::App& app);

}  // namespace roomgraph
