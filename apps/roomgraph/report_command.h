#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** roomgraph report COMPARISON [MAP...]: the results of a comparison anew. */
std::function<int()> reportCommand(CLI::App& app);

}  // namespace roomgraph
