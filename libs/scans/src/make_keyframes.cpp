#include "roomgraph/scans/make_keyframes.h"

#include <mrpt/core/Clock.h>
#include <mrpt/system/datetime.h>

#include <cmath>

namespace roomgraph {
namespace {

Transform2D flat(const mrpt::poses::CPose3D& pose) { return {pose.x(), pose.y(), pose.yaw()}; }

/** Which way the beams of a scanner go, one after the other. It is the same for all its scans. */
class Beams {
 public:
  const std::vector<Point>& directions(const RangeScan& scan) {
    const bool isUpsideDown = scan.sensor.getRotationMatrix()(2, 2) < 0;
    const double turn = scan.rightToLeft != isUpsideDown ? 1 : -1;
    const double span = turn * double(scan.aperture), start = scan.sensor.yaw() - span / 2;
    const std::size_t count = scan.ranges.size();
    if (start == start_ && span == span_ && count == directions_.size()) return directions_;
    start_ = start, span_ = span;
    directions_.clear();
    // As MRPT inserts the beams into a grid.
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = start + span * double(i) / double(count);
      directions_.push_back({std::cos(angle), std::sin(angle)});
    }
    return directions_;
  }

 private:
  double start_ = 0, span_ = 0;  // [rad]
  std::vector<Point> directions_;
};

/** Where the beams met something, in the frame that the scan's sensor counts from. */
std::vector<Point> endsOf(const RangeScan& scan, const std::vector<Point>& beams, double maxRange) {
  const Point sensor{scan.sensor.x(), scan.sensor.y()};
  std::vector<Point> ends;
  ends.reserve(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double range = double(scan.ranges[i]);
    if (scan.isValid[i] && range <= maxRange) ends.push_back(sensor + range * beams[i]);
  }
  return ends;
}

/** Gives the ends in the frame of another pose. */
void moveTo(const Transform2D& pose, Keyframe& frame) {
  if (pose.x == frame.pose.x && pose.y == frame.pose.y && pose.phi == frame.pose.phi) return;
  const Transform2D change = pose.inverse() * frame.pose;
  for (Point& end : frame.ends) end = change(end);
  frame.pose = pose;
}

}  // namespace

std::vector<Keyframe> makeKeyframes(const PlacedScans& scans, double maxRange) {
  Beams beams;
  std::vector<Keyframe> frames;
  frames.reserve(scans.scans.size());
  for (const PlacedScan& placed : scans.scans) {
    Keyframe& frame = frames.emplace_back();
    frame.number = placed.keyFrame;
    frame.pose = flat(placed.from);
    frame.ends = endsOf(placed.scan, beams.directions(placed.scan), maxRange);
    moveTo(flat(placed.robot), frame);
    if (placed.scan.time != INVALID_TIMESTAMP) frame.time = mrpt::Clock::toDouble(placed.scan.time);
    frame.scanId = placed.id;
  }
  return frames;
}

}  // namespace roomgraph
