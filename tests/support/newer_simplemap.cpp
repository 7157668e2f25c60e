#include "newer_simplemap.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>

#include "map_files.h"
#include "simplemap_entry.h"

namespace roomgraph::test {
namespace {

std::string textBytes(const std::string& text) { return raw(std::uint32_t(text.size())) + text; }

std::string headerBytes(const std::string& className, int version) {
  return std::string(1, char(0x80 | className.size())) + className + char(version);
}

std::string observationBytes(const mrpt::obs::CObservation& observation, int scanVersion) {
  std::string bytes = streamed(observation);
  if (!dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation)) return bytes;
  // How long the sweep took stands in front of the end from version 8, MRPT 2.15, on.
  char& version = bytes[1 + std::size_t(bytes[0] & 0x7f)];
  if (version == 8) bytes.erase(bytes.size() - 5, sizeof(float));
  version = char(scanVersion);
  if (scanVersion == 8) bytes.insert(bytes.size() - 1, raw(0.1f));
  return bytes;
}

}  // namespace

std::string twistBytes(bool hasTwist) {
  std::string bytes = textBytes("std::optional") + textBytes("TTwist3D") + char(hasTwist);
  if (hasTwist)
    for (int i = 0; i < 6; ++i) bytes += raw(0.1 * i);
  return bytes;
}

std::string simplemapBytes(int version, const std::vector<std::string>& entries) {
  std::string bytes =
      headerBytes("mrpt::maps::CSimpleMap", version) + raw(std::uint32_t(entries.size()));
  for (const std::string& entry : entries) bytes += entry;
  return bytes + "\x88";
}

std::string frameBytes(const std::vector<std::string>& observations) {
  std::string bytes =
      headerBytes("mrpt::obs::CSensoryFrame", 2) + raw(std::uint32_t(observations.size()));
  for (const std::string& observation : observations) bytes += observation;
  return bytes + "\x88";
}

std::string asNewer(const mrpt::maps::CSimpleMap& map, const Newer& how) {
  mrpt::obs::CObservationComment comment;
  comment.text = "local_velocity: [0.1, 0, 0]\n\x88\x88";
  const std::string twist = how.mapVersion >= 2 ? twistBytes(how.hasTwist) : "";
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto [pose, frame] = entryOf(map, i);
    std::vector<std::string> observations;
    for (const auto& observation : *frame)
      observations.push_back(observationBytes(*observation, how.scanVersion));
    if (how.hasComments) observations.push_back(streamed(comment));
    entries.push_back(streamed(*pose) + frameBytes(observations) + twist);
    if (how.hasEmptyFrames) entries.push_back(streamed(*pose) + frameBytes({}) + twist);
  }
  return simplemapBytes(how.mapVersion, entries);
}

}  // namespace roomgraph::test
