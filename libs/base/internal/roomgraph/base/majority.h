#pragma once

namespace roomgraph {

/** The share, or the probability, from which on something is so rather than not: where nothing was
 *  fitted, as nothing speaks for another one. */
constexpr double kMajority = 0.5;

}  // namespace roomgraph
