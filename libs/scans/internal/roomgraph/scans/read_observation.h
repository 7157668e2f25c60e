#pragma once
#include "roomgraph/scans/RangeScan.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {

/** Reads what follows the header of a CObservation2DRangeScan, versions 0 to 8, its end included.
 *  Ranges that are no length (NaN, negative) become invalid ones. Throws DataError where anything
 *  contradicts the format or a number is absurd. */
void readScan(ByteReader& reader, const ObjectHeader& header, RangeScan& scan);

}  // namespace roomgraph
