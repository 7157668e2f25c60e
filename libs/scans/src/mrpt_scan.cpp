#include "roomgraph/scans/mrpt_scan.h"

namespace roomgraph {

mrpt::obs::CObservation2DRangeScan mrptScan(const RangeScan& scan) {
  mrpt::obs::CObservation2DRangeScan result;
  result.sensorPose = scan.sensor;
  result.sensorLabel = scan.label;
  result.timestamp = scan.time;
  result.aperture = scan.aperture;
  result.maxRange = scan.maxRange;
  result.rightToLeft = scan.rightToLeft;
  result.loadFromVectors(scan.ranges.size(), scan.ranges.data(),
                         reinterpret_cast<const char*>(scan.isValid.data()));
  return result;
}

}  // namespace roomgraph
