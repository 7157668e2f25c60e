#pragma once
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** Makes the camera look at all of the box [m] from above, slightly tilted, in even light. The box
 *  is one of the scene turned by `turn` [rad] about its origin, as the camera shows it. */
void lookFromAbove(MrptScene& scene, const Box& box, double turn = 0);

}  // namespace roomgraph
