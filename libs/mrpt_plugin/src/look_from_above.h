#pragma once
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** Makes the camera look at all of the box [m] from above, slightly tilted, in even light. */
void lookFromAbove(MrptScene& scene, const Box& box);

}  // namespace roomgraph
