#pragma once
#include <mrpt/math/TPoint3D.h>

#include <vector>

#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

/** The points that the packets of a laser scanner mean [m, sensor frame]; MRPT knows its geometry.
 *  None where a packet or the number of lasers is not one that MRPT knows. */
std::vector<mrpt::math::TPoint3Df> velodynePoints(const VelodynePackets& from);

}  // namespace roomgraph
