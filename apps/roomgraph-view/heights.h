#pragma once

namespace roomgraph {

// How high above the maps things are drawn, so that none hides in another [m].
constexpr double kHeatHeight = -0.1;  // below
constexpr double kStageHeight = 0.2, kPathHeight = 2, kFrameHeight = 2.2, kMarkHeight = 2.4;

}  // namespace roomgraph
