#include "roomgraph/scans/read_run_info.h"

#include <mrpt/system/datetime.h>

#include <algorithm>

#include "roomgraph/scans/read_entries.h"

namespace roomgraph {
namespace {

void addTime(mrpt::Clock::time_point time, RunInfo& info) {
  if (time == INVALID_TIMESTAMP) return;
  const double seconds = mrpt::Clock::toDouble(time);
  info.start = std::min(info.start.value_or(seconds), seconds);
  info.end = std::max(info.end.value_or(seconds), seconds);
}

std::string sensorName(const ObservationKind& kind) {
  const std::string type = kind.className + " " + std::to_string(kind.version);
  return kind.label.empty() ? type : kind.label + " (" + type + ")";
}

}  // namespace

RunInfo readRunInfo(CheckedFile& file) {
  checkSimplemapHead(ByteReader(file.head(), file.name()), file.claimedSize());
  RunInfo info;
  info.compression = file.compression();
  ByteReader in(file.content(), file.name());
  info.sha256 = file.sha256();
  info.version = readObjectHeader(in).version;
  std::optional<mrpt::poses::CPose3D> before;
  readEntries(ByteReader(file.content(), file.name()), [&](const SimplemapEntry& entry) {
    ++info.keyframes;
    info.keyframesWithoutScans += entry.scans.empty() && entry.clouds.empty();
    if (before) info.pathLength += before->distanceTo(entry.robot);
    before = entry.robot;
    for (const auto& scan : entry.scans) addTime(scan.time, info);
    for (const PointCloud& cloud : entry.clouds) addTime(cloud.time, info);
    for (const ObservationKind& kind : entry.observations) ++info.sensors[sensorName(kind)];
  });
  return info;
}

}  // namespace roomgraph
