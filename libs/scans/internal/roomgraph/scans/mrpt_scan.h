#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include "roomgraph/scans/RangeScan.h"

namespace roomgraph {

// In:   a scan of PlacedScans
// Out:  MRPT's CObservation2DRangeScan
// Next: rawlogBytes

/** The scan as MRPT's programs and its grid want it. */
mrpt::obs::CObservation2DRangeScan mrptScan(const RangeScan& scan);

}  // namespace roomgraph
