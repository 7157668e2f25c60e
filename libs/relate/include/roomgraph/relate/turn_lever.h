#pragma once

namespace roomgraph {

/** How far away a turn is felt, where turns and shifts are weighed against each other [m]. */
constexpr double kTurnLever = 10;

}  // namespace roomgraph
