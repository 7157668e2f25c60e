#pragma once
#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

/** Reads what follows the header of a CObservation3DRangeScan: the points that it holds, else those
 *  that its depth image means. Lens distortion is not undone. Label and time are read from MRPT 2.1
 *  on. */
void readDepthScan(ByteReader& reader, const ObjectHeader& header, PointCloud& cloud);

}  // namespace roomgraph
