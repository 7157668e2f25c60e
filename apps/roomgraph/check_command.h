#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph check`. */
std::function<int()> checkCommand(CLI::App& app);

}  // namespace roomgraph
