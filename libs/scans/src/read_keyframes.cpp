#include "roomgraph/scans/read_keyframes.h"

#include <mrpt/core/Clock.h>

#include <cmath>

#include "roomgraph/scans/mrpt_object.h"
#include "roomgraph/scans/place_scans.h"

namespace roomgraph {
namespace {

Keyframe keyframeOf(const mrpt::poses::CPose3D& robot,
                    const mrpt::obs::CObservation2DRangeScan& scan, double maxRange) {
  Keyframe frame;
  frame.pose = {robot.x(), robot.y(), robot.yaw()};
  if (scan.timestamp != INVALID_TIMESTAMP) frame.time = mrpt::Clock::toDouble(scan.timestamp);
  const auto& sensor = scan.sensorPose;
  const bool isUpsideDown = sensor.getRotationMatrix()(2, 2) < 0;
  const double turn = scan.rightToLeft != isUpsideDown ? 1 : -1;
  const double aperture = double(scan.aperture), start = sensor.yaw() - turn * aperture / 2;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    const double range = double(scan.getScanRange(i));
    if (!scan.getScanRangeValidity(i) || range > maxRange) continue;
    // As MRPT inserts the beams into a grid.
    const double angle = start + turn * aperture * double(i) / double(scan.getScanSize());
    frame.ends.push_back(
        {sensor.x() + range * std::cos(angle), sensor.y() + range * std::sin(angle)});
  }
  return frame;
}

/** Gives the ends in the frame of another pose. */
void moveTo(const Transform2D& pose, Keyframe& frame) {
  if (pose.x == frame.pose.x && pose.y == frame.pose.y && pose.phi == frame.pose.phi) return;
  const Transform2D change = pose.inverse() * frame.pose;
  for (Point& end : frame.ends) end = change(end);
  frame.pose = pose;
}

std::optional<Transform2D> odometryOf(const SimplemapEntry& entry) {
  if (!entry.odometry) return std::nullopt;
  return Transform2D{entry.odometry->x(), entry.odometry->y(), entry.odometry->phi()};
}

/** Calls `visit` for each scan of the simplemap. */
void visitScans(CheckedFile& file, const LoadGridOptions& options, const ScanVisitor& visit) {
  checkSimplemapHead(ByteReader(file.head(), file.name()), file.claimedSize());
  const ByteReader in(file.content(), file.name());
  placeScans(in, findScans(in, options), visit);
}

}  // namespace

std::vector<Keyframe> readKeyframes(CheckedFile& file, const LoadGridOptions& options) {
  std::vector<Keyframe> frames;
  visitScans(file, options, [&](const SimplemapEntry& entry, const PlacedScan& placed) {
    Keyframe frame = keyframeOf(placed.robot, placed.scan, options.maxDistanceInsertion);
    moveTo({entry.robot.x(), entry.robot.y(), entry.robot.yaw()}, frame);
    frame.number = entry.number;
    frame.scanId = placed.id;
    frame.odometry = odometryOf(entry);
    frames.push_back(std::move(frame));
  });
  return frames;
}

std::vector<RobotScan> readRobotScans(CheckedFile& file, const LoadGridOptions& options) {
  std::vector<RobotScan> scans;
  visitScans(file, options, [&](const SimplemapEntry& entry, const PlacedScan& placed) {
    scans.push_back({entry.number, placed.robot, placed.scan});
  });
  return scans;
}

}  // namespace roomgraph
