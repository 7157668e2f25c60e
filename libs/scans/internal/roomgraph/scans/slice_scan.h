#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>

#include "roomgraph/scans/PointCloud.h"
#include "roomgraph/scans/find_slice.h"

namespace roomgraph {

// In:   PointCloud, Slice
// Out:  PlacedScan
// Next: placeScans

/** A horizontal scan and the place that it is seen from. */
struct PlacedScan {
  mrpt::poses::CPose3D robot;  ///< map <- robot; the scan's own pose counts from it
  mrpt::obs::CObservation2DRangeScan scan;
  std::uint64_t id = 0;  ///< see Keyframe::scanId
};

/** The identity of a scan: of its valid ranges, and where the others are. */
std::uint64_t rangesId(const mrpt::obs::CObservation2DRangeScan& scan);

/** What a scanner at the place of the cloud's sensor, all round and level, would have seen in the
 *  slice: of each direction the nearest point, and between two points of one surface what joins
 *  them. Other directions are invalid. Heights of the slice count from the robot's. */
PlacedScan sliceScan(const PointCloud& cloud, const mrpt::poses::CPose3D& robot,
                     const Slice& slice);

}  // namespace roomgraph
