#pragma once
#include "Scene.h"
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

/** The picture of the result; `stages` must outlive it. */
Scene resultScene(const Stages& stages);

/** Passages and clutter, where there are any. */
std::vector<LegendItem> areaLegend(const Stages& stages);

/** "0.05 m per cell" */
std::string resolutionText(double metres);

}  // namespace roomgraph
