#include "roomgraph/scans/read_entries.h"

#include "roomgraph/base/remedies.h"
#include "roomgraph/scans/mrpt_object.h"
#include "roomgraph/scans/read_observation.h"

namespace roomgraph {
namespace {

// A header with its class name, twice: less cannot be an entry.
constexpr std::uint64_t kSmallestEntry = 32;
constexpr std::uint64_t kSmallestObservation = 16;

bool isPoseClass(const std::string& name) {
  return name.compare(0, 5, "CPose") == 0 && name.find("PDF") != std::string::npos;
}

bool isObservationClass(const std::string& name) {
  return name.compare(0, 12, "CObservation") == 0;
}

/** From version 2 on, an entry ends with how fast the robot was, where that is known. */
void skipTwist(ByteReader& in) {
  if (!startsWithOptional({in.peek(), in.left()}))
    refuse(in.file(), "it is damaged: an entry in it does not end where it should", kSaveMapAgain);
  readText(in);
  in.skip(in.get<std::uint32_t>());  // the name of its type
  if (in.getFlag()) in.skip(6 * sizeof(double));
}

/** Whether an observation may end just before `bytes`: another follows, or the frame ends and with
 *  it the map or the entry. */
bool followsObservation(ByteView bytes, bool isLast, int mapVersion) {
  if (!isLast) {
    const auto next = peekObjectHeader(bytes);
    return next && !next->isOldFormat && isObservationClass(next->className);
  }
  if (bytes.size < 2 || bytes.data[0] != kObjectEnd) return false;
  const ByteView rest{bytes.data + 1, bytes.size - 1};
  if (mapVersion >= 2) return startsWithOptional(rest);
  if (rest.size == 1) return rest.data[0] == kObjectEnd;
  const auto next = peekObjectHeader(rest);
  return next && !next->isOldFormat && isPoseClass(next->className);
}

/** Steps over an observation whose layout is not known here, to the place where the next object is
 *  announced. Its bytes never reach a reader that would believe them. */
void skipObservation(ByteReader& in, const ObjectHeader& header, bool isLast, int mapVersion) {
  if (header.isOldFormat)
    refuse(in.file(), "holds a " + header.className + " in the format of MRPT before 0.5.5",
           "load and save the map with a newer MRPT");
  while (in.left() > 0) {
    const void* end = std::memchr(in.peek(), kObjectEnd, in.left());
    if (!end) break;
    in.skip(std::uint64_t(static_cast<const std::uint8_t*>(end) - in.peek()) + 1);
    if (followsObservation({in.peek(), in.left()}, isLast, mapVersion)) return;
  }
  refuse(in.file(), "it is cut short or damaged", kSaveMapAgain);
}

/** One observation of those that are known, or the step over it. */
void readObservation(ByteReader& in, SimplemapEntry& entry, bool isLast, int mapVersion) {
  const ObjectHeader header = readObjectHeader(in);
  ObservationKind& kind = entry.observations.emplace_back();
  kind.className = header.className, kind.version = header.version;
  if (header.className == "CObservation2DRangeScan") {
    readScan(in, header, entry.scans.emplace_back());
    kind.label = entry.scans.back().label;
    return;
  }
  if (isCloudClass(header.className)) {
    entry.clouds.push_back(readCloud(in, header));
    kind.label = entry.clouds.back().label;
  }
  if (header.className == "CObservationOdometry")
    if (const auto odometry = readOdometry(in, header)) entry.odometry = odometry;
  skipObservation(in, header, isLast, mapVersion);
}

void readFrame(ByteReader& in, SimplemapEntry& entry, int mapVersion) {
  const ObjectHeader frame = readObjectHeader(in);
  if (frame.className != "CSensoryFrame" && frame.className != "CSensorialFrame")
    refuse(in.file(), "it is damaged: an entry in it has no observations", kSaveMapAgain);
  checkVersion(in, frame, 2);
  if (frame.version < 2) in.skip(4);   // id
  if (frame.version == 0) in.skip(8);  // time
  const auto count = in.get<std::uint32_t>();
  if (count > in.left() / kSmallestObservation)
    refuse(in.file(), "it is damaged: an entry claims " + std::to_string(count) + " observations",
           kSaveMapAgain);
  for (std::uint32_t i = 0; i < count; ++i) readObservation(in, entry, i + 1 == count, mapVersion);
  readObjectEnd(in, frame);
}

std::uint32_t readCount(ByteReader& in, std::uint64_t bytesLeft) {
  const auto count = in.get<std::uint32_t>();
  if (count > bytesLeft / kSmallestEntry)
    refuse(in.file(), "it is damaged: it claims " + std::to_string(count) + " entries",
           kSaveMapAgain);
  return count;
}

ObjectHeader readMapHeader(ByteReader& in) {
  ObjectHeader header = readObjectHeader(in);
  checkVersion(in, header, 2);
  return header;
}

}  // namespace

void checkSimplemapHead(ByteReader head, std::uint64_t size) {
  readMapHeader(head);
  readCount(head, size);
}

void readEntries(ByteReader in, const EntryVisitor& visit) {
  const ObjectHeader map = readMapHeader(in);
  const std::uint32_t count = readCount(in, in.left());
  for (std::uint32_t k = 0; k < count; ++k) {
    SimplemapEntry entry;
    entry.number = k;
    entry.robot = readPoseMean(in);
    readFrame(in, entry, map.version);
    if (map.version >= 2) skipTwist(in);
    visit(entry);
  }
  readObjectEnd(in, map);
  if (in.left() > 0)
    refuse(in.file(), "something follows the map in it", "remove what was appended");
}

}  // namespace roomgraph
