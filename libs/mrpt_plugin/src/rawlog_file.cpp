#include "roomgraph/mrpt_plugin/rawlog_file.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "object_bytes.h"
#include "roomgraph/base/compressed.h"
#include "roomgraph/scans/mrpt_scan.h"

namespace roomgraph {
namespace {

mrpt::obs::CActionCollection actionOf(const mrpt::poses::CPose2D& way,
                                      mrpt::Clock::time_point time) {
  mrpt::obs::CActionRobotMovement2D movement;
  movement.timestamp = time;
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
  movement.computeFromOdometry(way, model);
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  return actions;
}

}  // namespace

std::string rawlogBytes(const std::vector<PlacedScan>& scans) {
  std::string bytes;
  mrpt::poses::CPose2D before;
  for (const PlacedScan& one : scans) {
    const mrpt::poses::CPose2D pose(one.from);
    bytes += objectBytes(actionOf(pose - before, one.scan.time));
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservation2DRangeScan::Create(mrptScan(one.scan)));
    bytes += objectBytes(frame);
    before = pose;
  }
  return gzipped(bytes, kGzipMark);
}

std::vector<PlacedScan> moved(std::vector<PlacedScan> scans, const Transform2D& motion) {
  const mrpt::poses::CPose3D change(motion.x, motion.y, 0, motion.phi, 0, 0);
  for (PlacedScan& one : scans) one.from = change + one.from;
  return scans;
}

}  // namespace roomgraph
