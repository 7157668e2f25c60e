#pragma once
#include <cstddef>
#include <string>

#include "roomgraph/mrpt_plugin/mrpt_compat.h"
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** A stage of an extraction in 3D, on its map but without it [m, map frame]. `stage` counts those
 *  of stageNames(). O(size of the stage). */
viz::CSetOfObjects::Ptr drawStage(const Stages& stages, std::size_t stage);

/** "7 of 16, III-A: without dead ends that lead nowhere; 34 vertices, 40 edges". */
std::string stageLine(const Stages& stages, std::size_t stage);

// How high above the maps things are drawn, so that none hides in another [m].
constexpr double kHeatHeight = -0.1;  // below
constexpr double kStageHeight = 0.2, kPathHeight = 2, kFrameHeight = 2.2, kMarkHeight = 2.4;

}  // namespace roomgraph
