#pragma once
#include <mrpt/poses/CPose3D.h>

#include <cstdint>

#include "roomgraph/scans/PlacedScan.h"
#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/find_slice.h"

namespace roomgraph {

// In:   the points of a PointCloud, Slice
// Out:  PlacedScan
// Next: placeScans

/** The identity of a scan: of its valid ranges, and where the others are. */
std::uint64_t rangesId(const RangeScan& scan);

/** What a scanner at the place of the points' sensor (map <- sensor), all round and level, would
 *  have seen in the slice: of each direction the nearest point, and between two points of one
 *  surface what joins them. Other directions are invalid. Heights of the slice count from
 *  `ground`. Fills `from`, the id, and the ranges of the scan. */
PlacedScan sliceScan(const CloudPoints& points, const mrpt::poses::CPose3D& sensor, double ground,
                     const Slice& slice);

}  // namespace roomgraph
