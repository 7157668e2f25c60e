#include "roomgraph/scans/slice_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace roomgraph {
namespace {

constexpr std::size_t kBeams = 3600;
constexpr float kNothing = HUGE_VALF;

/** FNV-1a. */
class Hash {
 public:
  void add(float value) {
    std::array<std::uint8_t, sizeof value> bytes;
    std::memcpy(bytes.data(), &value, sizeof value);
    for (const std::uint8_t byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t pointsId(const CloudPoints& points) {
  Hash hash;
  for (const auto& point : points) hash.add(point.x), hash.add(point.y), hash.add(point.z);
  return hash.value();
}

/** Fills directions between two points of one surface: a scanner has fewer than there are here. */
void bridgeGaps(std::vector<float>& ranges) {
  constexpr std::size_t widest = 10;  // a degree
  constexpr float deepest = 0.2f;     // between the points [m]
  for (std::size_t i = 0; i < kBeams; ++i) {
    if (ranges[i] == kNothing) continue;
    std::size_t gap = 1;
    while (gap <= widest && ranges[(i + gap) % kBeams] == kNothing) ++gap;
    const float here = ranges[i], there = ranges[(i + gap) % kBeams];
    if (gap == 1 || there == kNothing || std::abs(here - there) > deepest) continue;
    for (std::size_t k = 1; k < gap; ++k)
      ranges[(i + k) % kBeams] = here + (there - here) * float(k) / float(gap);
  }
}

}  // namespace

std::uint64_t rangesId(const RangeScan& scan) {
  Hash hash;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    hash.add(scan.isValid[i] ? scan.ranges[i] : -1);
  return hash.value();
}

PlacedScan sliceScan(const CloudPoints& points, const mrpt::poses::CPose3D& sensor, double ground,
                     const Slice& slice) {
  std::vector<float> ranges(kBeams, kNothing);
  for (const auto& point : points) {
    const auto p = sensor.composePoint(mrpt::math::TPoint3D(point));
    const double dx = p.x - sensor.x(), dy = p.y - sensor.y(), range = std::hypot(dx, dy);
    // What is nearer than 0.2 m is the robot itself.
    if (range < 0.2 || !slice.contains(p.z - ground)) continue;
    const double turns = std::atan2(dy, dx) / (2 * M_PI) + 0.5;
    auto& nearest = ranges[std::size_t(std::lround(turns * kBeams)) % kBeams];
    nearest = std::min(nearest, float(range));
  }
  bridgeGaps(ranges);
  PlacedScan placed;
  placed.from = mrpt::poses::CPose3D(sensor.x(), sensor.y(), 0);
  placed.id = pointsId(points);
  RangeScan& scan = placed.scan;
  scan.aperture = float(2 * M_PI);
  scan.maxRange = 80;  // what MRPT takes for granted where nobody says it [m]
  scan.isValid.resize(kBeams);
  for (std::size_t i = 0; i < kBeams; ++i) {
    scan.isValid[i] = ranges[i] != kNothing;
    if (!scan.isValid[i]) ranges[i] = 0;
  }
  scan.ranges = std::move(ranges);
  return placed;
}

}  // namespace roomgraph
