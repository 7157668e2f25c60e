#include "read_scans.h"

#include <cmath>
#include <vector>

#include "roomgraph/grid/mrpt_object.h"

namespace roomgraph {
namespace {

using mrpt::obs::CObservation2DRangeScan;

constexpr const char* kSaveAgain = "copy or save the map again";
// MRPT keeps the beams of a scan on the stack while it inserts them.
constexpr std::uint32_t kMostBeams = 100'000;
// A header with its class name, twice: less cannot be an entry.
constexpr std::uint64_t kSmallestEntry = 32;
constexpr std::uint64_t kSmallestObservation = 16;

bool isPoseClass(const std::string& name) {
  return name.compare(0, 5, "CPose") == 0 && name.find("PDF") != std::string::npos;
}

bool isObservationClass(const std::string& name) {
  return name.compare(0, 12, "CObservation") == 0;
}

/** Fills in the beams. */
void readBeams(ByteReader& in, int version, CObservation2DRangeScan& scan) {
  const auto count = in.get<std::uint32_t>();
  if (count > kMostBeams)
    refuse(in.file(), "it is damaged: a scan in it claims " + std::to_string(count) + " beams",
           kSaveAgain);
  const std::uint8_t* ranges = in.take(std::uint64_t(count) * sizeof(float));
  const std::uint8_t* validity = version >= 1 ? in.take(count) : nullptr;
  scan.resizeScan(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    float range;
    std::memcpy(&range, ranges + i * sizeof(float), sizeof(float));
    const bool isValid = validity ? validity[i] != 0 : range < scan.maxRange;
    const bool isLength = range >= 0;
    scan.setScanRange(i, isLength ? range : 0);
    scan.setScanRangeValidity(i, isValid && isLength);
  }
}

/** Counts 100 ns from 1601 on; 0 stands for none. */
mrpt::Clock::time_point readTime(ByteReader& in) {
  return mrpt::Clock::time_point(mrpt::Clock::duration(in.get<std::int64_t>()));
}

/** What stands behind the beams. */
void readScanEnd(ByteReader& in, int version, CObservation2DRangeScan& scan) {
  if (version >= 2) in.skip(4);  // standard deviation
  scan.timestamp = version >= 3 ? readTime(in) : INVALID_TIMESTAMP;
  if (version >= 4) in.skip(4);  // beam aperture
  if (version >= 5) {
    in.skip(in.get<std::uint32_t>());  // label
    in.skip(8);                        // pitch
  }
  if (version >= 7 && in.getFlag()) in.skip(std::uint64_t(scan.getScanSize()) * 4);  // intensity
}

void readScan(ByteReader& in, const ObjectHeader& header, CObservation2DRangeScan& scan) {
  checkVersion(in, header, 7);
  scan.aperture = in.get<float>();
  scan.rightToLeft = in.getFlag();
  scan.maxRange = in.get<float>();
  if (!(scan.aperture >= 0 && scan.aperture < 7))
    refuse(in.file(), "it is damaged: a scan in it has an absurd field of view", kSaveAgain);
  scan.sensorPose = readPose3D(in);
  if (header.version < 6) skipMatrix(in);
  readBeams(in, header.version, scan);
  readScanEnd(in, header.version, scan);
  readObjectEnd(in, header);
}

/** Whether an observation may end just before `bytes`: another follows, or the frame ends and with
 *  it the map or the entry. */
bool followsObservation(ByteView bytes, bool isLast) {
  if (!isLast) {
    const auto next = peekObjectHeader(bytes);
    return next && !next->isOldFormat && isObservationClass(next->className);
  }
  if (bytes.size < 2 || bytes.data[0] != kObjectEnd) return false;
  if (bytes.size == 2) return bytes.data[1] == kObjectEnd;
  const auto next = peekObjectHeader({bytes.data + 1, bytes.size - 1});
  return next && !next->isOldFormat && isPoseClass(next->className);
}

/** Steps over an observation whose layout is not known here, to the place where the next object is
 *  announced. Its bytes never reach a reader that would believe them. */
void skipObservation(ByteReader& in, const ObjectHeader& header, bool isLast) {
  if (header.isOldFormat)
    refuse(in.file(), "holds a " + header.className + " in the format of MRPT before 0.5.5",
           "load and save the map with a newer MRPT");
  while (in.left() > 0) {
    const void* end = std::memchr(in.peek(), kObjectEnd, in.left());
    if (!end) break;
    in.skip(std::uint64_t(static_cast<const std::uint8_t*>(end) - in.peek()) + 1);
    if (followsObservation({in.peek(), in.left()}, isLast)) return;
  }
  refuse(in.file(), "it is cut short or damaged", kSaveAgain);
}

void readFrame(ByteReader& in, const mrpt::poses::CPose3D& robot, const ScanVisitor& visit,
               SimplemapCounts& counts) {
  const ObjectHeader frame = readObjectHeader(in);
  if (frame.className != "CSensoryFrame" && frame.className != "CSensorialFrame")
    refuse(in.file(), "it is damaged: an entry in it has no observations", kSaveAgain);
  checkVersion(in, frame, 2);
  if (frame.version < 2) in.skip(4);   // id
  if (frame.version == 0) in.skip(8);  // time
  const auto count = in.get<std::uint32_t>();
  if (count > in.left() / kSmallestObservation)
    refuse(in.file(), "it is damaged: an entry claims " + std::to_string(count) + " observations",
           kSaveAgain);
  for (std::uint32_t i = 0; i < count; ++i) {
    const ObjectHeader header = readObjectHeader(in);
    if (header.className == "CObservation2DRangeScan") {
      CObservation2DRangeScan scan;
      readScan(in, header, scan);
      ++counts.scans;
      visit(robot, scan);
    } else {
      skipObservation(in, header, i + 1 == count);
      ++counts.others;
    }
  }
  readObjectEnd(in, frame);
}

std::uint32_t readCount(ByteReader& in, std::uint64_t bytesLeft) {
  const auto count = in.get<std::uint32_t>();
  if (count > bytesLeft / kSmallestEntry)
    refuse(in.file(), "it is damaged: it claims " + std::to_string(count) + " entries", kSaveAgain);
  return count;
}

ObjectHeader readMapHeader(ByteReader& in) {
  ObjectHeader header = readObjectHeader(in);
  checkVersion(in, header, 1);
  return header;
}

}  // namespace

bool isSimplemapClass(const std::string& className) {
  return className == "CSimpleMap" || className == "CSensFrameProbSequence";
}

void checkSimplemapHead(ByteReader head, std::uint64_t size) {
  readMapHeader(head);
  readCount(head, size);
}

SimplemapCounts readScans(ByteReader in, const ScanVisitor& visit) {
  const ObjectHeader map = readMapHeader(in);
  SimplemapCounts counts;
  counts.entries = readCount(in, in.left());
  for (std::size_t i = 0; i < counts.entries; ++i) {
    const mrpt::poses::CPose3D robot = readPoseMean(in);
    readFrame(in, robot, visit, counts);
  }
  readObjectEnd(in, map);
  if (in.left() > 0)
    refuse(in.file(), "something follows the map in it", "remove what was appended");
  return counts;
}

}  // namespace roomgraph
