#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph watch`. */
std::function<int()> watchCommand(CLI::App& app);

}  // namespace roomgraph
