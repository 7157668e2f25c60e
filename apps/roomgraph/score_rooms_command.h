#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace roomgraph {

/** `roomgraph score-rooms`, as Command::declare. */
std::function<int()> scoreRoomsCommand(CLI::App& app);

}  // namespace roomgraph
