#pragma once
#include <string>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

/** Whether the points of a metric map's layer of this class can be read: MRPT's point maps, and
 *  MOLA's IncrementalPointCloud and KeyframePointCloudMap. */
bool hasLayerPoints(const std::string& className);

/** Reads the points of the layer whose object begins here, in the frame of the map. What follows
 *  its last point is left. */
CloudPoints readLayerPoints(ByteReader& reader);

}  // namespace roomgraph
