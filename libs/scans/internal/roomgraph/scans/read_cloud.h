#pragma once
#include <string>

#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

/** Whether readCloud() knows the class: CObservationPointCloud, CObservation3DRangeScan,
 *  CObservationVelodyneScan and CObservationRotatingScan. */
bool isCloudClass(const std::string& className);

/** Reads the points that follow the header of such an observation, wherever they are kept, and
 *  leaves what is behind them. Files beside the map are looked for in NAME_Images, as MOLA writes
 *  them, and beside it. Throws DataError for a newer version, and where anything contradicts the
 *  format. */
PointCloud readCloud(ByteReader& reader, const ObjectHeader& header);

}  // namespace roomgraph
