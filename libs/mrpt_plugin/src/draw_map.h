#pragma once
#include "roomgraph/grid/Grid.h"
#include "roomgraph/mrpt_plugin/mrpt_compat.h"

namespace roomgraph {

/** A map with more cells than this on a side is drawn coarser. */
constexpr int kMostTexels = 2048;

/** The map as a textured plane at z = 0, shifted by -`anchor`. A cell of the picture shows the
 *  darkest of the map cells that it stands for, so that thin walls stay. O(cells). */
viz::CTexturedPlane::Ptr drawMap(const Grid& map, Point anchor);

}  // namespace roomgraph
