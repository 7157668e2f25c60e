#include "roomgraph/scans/Recording.h"

#include <mrpt/system/datetime.h>

#include <algorithm>
#include <tuple>

#include "roomgraph/base/sequences.h"

namespace roomgraph {

std::optional<double> Recording::Frame::time() const {
  for (const RangeScan& scan : scans)
    if (scan.time != INVALID_TIMESTAMP) return mrpt::Clock::toDouble(scan.time);
  for (const PointCloud& cloud : clouds)
    if (cloud.time != INVALID_TIMESTAMP) return mrpt::Clock::toDouble(cloud.time);
  return std::nullopt;
}

std::string Recording::Sensor::name() const {
  const std::string type = className + " " + std::to_string(version);
  return label.empty() ? type : label + " (" + type + ")";
}

bool Recording::Sensor::operator<(const Sensor& other) const {
  return std::tie(className, version, label) <
         std::tie(other.className, other.version, other.label);
}

std::size_t Recording::framesWithoutScans() const {
  return countIf(frames,
                 [](const Frame& frame) { return frame.scans.empty() && frame.clouds.empty(); });
}

double Recording::pathLength() const {
  double length = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    length += frames[i - 1].robot.distanceTo(frames[i].robot);
  return length;
}

std::optional<std::pair<double, double>> Recording::times() const {
  std::optional<std::pair<double, double>> times;
  const auto add = [&](const auto& seen) {
    if (seen.time == INVALID_TIMESTAMP) return;
    const double time = mrpt::Clock::toDouble(seen.time);
    if (!times) times.emplace(time, time);
    times->first = std::min(times->first, time);
    times->second = std::max(times->second, time);
  };
  for (const Frame& frame : frames) {
    for (const RangeScan& scan : frame.scans) add(scan);
    for (const PointCloud& cloud : frame.clouds) add(cloud);
  }
  return times;
}

}  // namespace roomgraph
