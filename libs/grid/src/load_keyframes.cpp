#include "roomgraph/grid/load_keyframes.h"

#include <mrpt/core/Clock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <array>
#include <cmath>
#include <cstring>

#include "read_entries.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/grid/checked_file.h"
#include "roomgraph/grid/mrpt_object.h"

namespace roomgraph {
namespace {

/** FNV-1a over the ranges and which of them are valid. */
std::uint64_t scanIdOf(const mrpt::obs::CObservation2DRangeScan& scan) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    const float range = scan.getScanRangeValidity(i) ? scan.getScanRange(i) : -1;
    std::array<std::uint8_t, sizeof range> bytes;
    std::memcpy(bytes.data(), &range, sizeof range);
    for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  }
  return hash;
}

Keyframe keyframeOf(const mrpt::poses::CPose3D& robot,
                    const mrpt::obs::CObservation2DRangeScan& scan, double maxRange) {
  Keyframe frame;
  frame.pose = {robot.x(), robot.y(), robot.yaw()};
  if (scan.timestamp != INVALID_TIMESTAMP) frame.time = mrpt::Clock::toDouble(scan.timestamp);
  frame.scanId = scanIdOf(scan);
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

std::optional<Transform2D> odometryOf(const SimplemapEntry& entry) {
  if (!entry.odometry) return std::nullopt;
  return Transform2D{entry.odometry->x(), entry.odometry->y(), entry.odometry->phi()};
}

}  // namespace

std::vector<Keyframe> loadKeyframes(const std::string& name, double maxRange) {
  CheckedFile file(name);
  const auto object = peekObjectHeader(file.head());
  if (!object || !isSimplemapClass(object->className)) return {};
  checkSimplemapHead(ByteReader(file.head(), file.name()), file.claimedSize());
  const auto tolerance =
      double(mrpt::maps::COccupancyGridMap2D::TInsertionOptions().horizontalTolerance);
  std::vector<Keyframe> frames;
  readEntries(ByteReader(file.content(), file.name()), [&](const SimplemapEntry& entry) {
    for (const auto& scan : entry.scans)
      if (scan.isPlanarScan(tolerance)) {
        frames.push_back(keyframeOf(entry.robot, scan, maxRange));
        frames.back().odometry = odometryOf(entry);
      }
  });
  return frames;
}

}  // namespace roomgraph
