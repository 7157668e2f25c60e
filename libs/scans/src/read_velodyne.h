#pragma once
#include "roomgraph/base/byte_reader.h"
#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

/** Reads what follows the header of a CObservationVelodyneScan, up to its points: those that it
 *  holds, else those that its packets mean. */
void readVelodyne(ByteReader& reader, PointCloud& cloud);

}  // namespace roomgraph
