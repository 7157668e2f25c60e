#pragma once
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** Made by hand: two rooms of 4 m x 4 m side by side, with a door between them, and a dead end that
 *  leaves the right one on a bent way; cells of 0.1 m. The left room has a hole. All kinds of
 *  vertices occur, two parallel edges and a self loop; two rooms and a corridor as areas, and a
 *  piece of clutter. */
Stages sampleStages();

/** The same map through the whole pipeline. */
Stages extractedStages();

}  // namespace roomgraph
