#include "roomgraph/mrpt_plugin/rawlog_file.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "object_bytes.h"

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

std::string rawlogBytes(const std::vector<RobotScan>& scans) {
  std::string bytes;
  mrpt::poses::CPose2D before;
  for (const RobotScan& one : scans) {
    const mrpt::poses::CPose2D pose(one.robot);
    bytes += objectBytes(actionOf(pose - before, one.scan.timestamp));
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservation2DRangeScan::Create(one.scan));
    bytes += objectBytes(frame);
    before = pose;
  }
  return gzipped(bytes);
}

std::vector<RobotScan> moved(std::vector<RobotScan> scans, const Transform2D& motion) {
  const mrpt::poses::CPose3D change(motion.x, motion.y, 0, motion.phi, 0, 0);
  for (RobotScan& one : scans) one.robot = change + one.robot;
  return scans;
}

}  // namespace roomgraph
