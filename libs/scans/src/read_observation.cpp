#include "roomgraph/scans/read_observation.h"

#include "roomgraph/base/checked_file.h"

namespace roomgraph {
namespace {

void readBeams(ByteReader& reader, int version, RangeScan& scan) {
  const auto count = reader.get<std::uint32_t>();
  if (count > 100'000)  // MRPT keeps them on the stack while it inserts them
    refuse(reader.file(), "it is damaged: a scan in it claims " + std::to_string(count) + " beams",
           kSaveMapAgain);
  const std::uint8_t* ranges = reader.take(std::uint64_t(count) * sizeof(float));
  const std::uint8_t* validity = version >= 1 ? reader.take(count) : nullptr;
  scan.ranges.resize(count);
  scan.isValid.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto range = valueAt<float>(ranges, i);
    const bool isValid = validity ? validity[i] != 0 : range < scan.maxRange;
    const bool isLength = range >= 0;
    scan.ranges[i] = isLength ? range : 0;
    scan.isValid[i] = isValid && isLength;
  }
}

/** What stands behind the beams. */
void readScanEnd(ByteReader& reader, int version, RangeScan& scan) {
  if (version >= 2) reader.skip(4);  // standard deviation
  scan.time = version >= 3 ? readTime(reader) : mrpt::Clock::time_point();
  if (version >= 4) reader.skip(4);  // beam aperture
  if (version >= 5) {
    scan.label = reader.getText();
    reader.skip(8);  // pitch
  }
  if (version >= 7 && reader.getFlag())
    reader.skip(std::uint64_t(scan.ranges.size()) * 4);  // intensity
  if (version >= 8) reader.skip(4);                      // how long the sweep took
}

}  // namespace

void readScan(ByteReader& reader, const ObjectHeader& header, RangeScan& scan) {
  checkVersion(reader, header, 8);
  scan.aperture = reader.get<float>();
  scan.rightToLeft = reader.getFlag();
  scan.maxRange = reader.get<float>();
  if (scan.aperture < 0) {  // of a ROS scan whose angles decrease
    scan.aperture = -scan.aperture;
    scan.rightToLeft = !scan.rightToLeft;
  }
  if (!(scan.aperture >= 0 && scan.aperture < 7))
    refuse(reader.file(), "it is damaged: a scan in it has an absurd field of view", kSaveMapAgain);
  scan.sensor = readPose3D(reader);
  if (header.version < 6) readMatrix(reader);
  readBeams(reader, header.version, scan);
  readScanEnd(reader, header.version, scan);
  readObjectEnd(reader, header);
}

}  // namespace roomgraph
