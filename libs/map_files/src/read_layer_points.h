#pragma once
#include <mrpt/math/TPoint3D.h>

#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

/** Whether the points of a metric map's layer of this class can be read: MRPT's point maps, and
 *  MOLA's IncrementalPointCloud and KeyframePointCloudMap. */
bool hasLayerPoints(const std::string& className);

/** Reads the points of the layer whose object begins here, in the frame of the map. What follows
 *  its last point is left. */
std::vector<mrpt::math::TPoint3Df> readLayerPoints(ByteReader& in);

}  // namespace roomgraph
