#include "roomgraph/scans/read_observation.h"

#include <cmath>

#include "roomgraph/base/remedies.h"

namespace roomgraph {
namespace {

/** Fills in the beams. */
void readBeams(ByteReader& in, int version, RangeScan& scan) {
  const auto count = in.get<std::uint32_t>();
  if (count > 100'000)  // MRPT keeps them on the stack while it inserts them
    refuse(in.file(), "it is damaged: a scan in it claims " + std::to_string(count) + " beams",
           kSaveMapAgain);
  const std::uint8_t* ranges = in.take(std::uint64_t(count) * sizeof(float));
  const std::uint8_t* validity = version >= 1 ? in.take(count) : nullptr;
  scan.ranges.resize(count);
  scan.isValid.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    float range;
    std::memcpy(&range, ranges + i * sizeof(float), sizeof(float));
    const bool isValid = validity ? validity[i] != 0 : range < scan.maxRange;
    const bool isLength = range >= 0;
    scan.ranges[i] = isLength ? range : 0;
    scan.isValid[i] = isValid && isLength;
  }
}

/** What stands behind the beams. */
void readScanEnd(ByteReader& in, int version, RangeScan& scan) {
  if (version >= 2) in.skip(4);  // standard deviation
  scan.time = version >= 3 ? readTime(in) : mrpt::Clock::time_point();
  if (version >= 4) in.skip(4);  // beam aperture
  if (version >= 5) {
    scan.label = readText(in);
    in.skip(8);  // pitch
  }
  if (version >= 7 && in.getFlag()) in.skip(std::uint64_t(scan.ranges.size()) * 4);  // intensity
  if (version >= 8) in.skip(4);  // how long the sweep took
}

}  // namespace

void readScan(ByteReader& in, const ObjectHeader& header, RangeScan& scan) {
  checkVersion(in, header, 8);
  scan.aperture = in.get<float>();
  scan.rightToLeft = in.getFlag();
  scan.maxRange = in.get<float>();
  if (scan.aperture < 0) {  // of a ROS scan whose angles decrease
    scan.aperture = -scan.aperture;
    scan.rightToLeft = !scan.rightToLeft;
  }
  if (!(scan.aperture >= 0 && scan.aperture < 7))
    refuse(in.file(), "it is damaged: a scan in it has an absurd field of view", kSaveMapAgain);
  scan.sensor = readPose3D(in);
  if (header.version < 6) skipMatrix(in);
  readBeams(in, header.version, scan);
  readScanEnd(in, header.version, scan);
  readObjectEnd(in, header);
}

std::optional<mrpt::poses::CPose2D> readOdometry(ByteReader& in, const ObjectHeader& header) {
  constexpr int newest = 2;
  if (header.version > newest) return std::nullopt;
  const mrpt::poses::CPose2D pose = readPose2D(in);
  if (!std::isfinite(pose.x()) || !std::isfinite(pose.y()) || !std::isfinite(pose.phi()))
    return std::nullopt;
  return pose;
}

}  // namespace roomgraph
