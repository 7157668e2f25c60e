#include "roomgraph/scans/read_simplemap.h"

#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/scans/mrpt_object.h"
#include "roomgraph/scans/read_cloud.h"
#include "roomgraph/scans/read_observation.h"

namespace roomgraph {
namespace {

// A header with its class name: less cannot be an object, such as an observation; an entry is two.
constexpr std::uint64_t kSmallestObject = 16;

bool isPoseClass(const std::string& name) {
  return name.compare(0, 5, "CPose") == 0 && name.find("PDF") != std::string::npos;
}

bool isObservationClass(const std::string& name) {
  return name.compare(0, 12, "CObservation") == 0;
}

/** From version 2 on, an entry ends with how fast the robot was, where that is known. */
void skipTwist(ByteReader& reader) {
  if (!startsWithOptional({reader.peek(), reader.left()}))
    refuse(reader.file(), "it is damaged: an entry in it does not end where it should",
           kSaveMapAgain);
  reader.getText();
  reader.skip(reader.get<std::uint32_t>());  // the name of its type
  if (reader.getFlag()) reader.skip(6 * sizeof(double));
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
void skipObservation(ByteReader& reader, const ObjectHeader& header, bool isLast, int mapVersion) {
  if (header.isOldFormat)
    refuse(reader.file(), "holds a " + header.className + " in the format of MRPT before 0.5.5",
           "load and save the map with a newer MRPT");
  skipObject(reader, [&](ByteView next) { return followsObservation(next, isLast, mapVersion); });
}

/** One observation of those that are known, or the step over it. */
void readObservation(ByteReader& reader, Recording& recording, bool isLast) {
  const ObjectHeader header = readObjectHeader(reader);
  Recording::Frame& frame = recording.frames.back();
  std::string label;
  if (header.className == "CObservation2DRangeScan") {
    readScan(reader, header, frame.scans.emplace_back());
    label = frame.scans.back().label;
  } else {
    if (isCloudClass(header.className)) {
      frame.clouds.push_back(readCloud(reader, header));
      label = frame.clouds.back().label;
    }
    skipObservation(reader, header, isLast, recording.version);
  }
  ++recording.sensors[{header.className, header.version, label}];
}

void readFrame(ByteReader& reader, Recording& recording) {
  const ObjectHeader frame = readObjectHeader(reader);
  if (frame.className != "CSensoryFrame" && frame.className != "CSensorialFrame")
    refuse(reader.file(), "it is damaged: an entry in it has no observations", kSaveMapAgain);
  checkVersion(reader, frame, 2);
  if (frame.version < 2) reader.skip(4);   // id
  if (frame.version == 0) reader.skip(8);  // time
  const auto count = reader.get<std::uint32_t>();
  if (count > reader.left() / kSmallestObject)
    refuse(reader.file(),
           "it is damaged: an entry claims " + std::to_string(count) + " observations",
           kSaveMapAgain);
  for (std::uint32_t i = 0; i < count; ++i) readObservation(reader, recording, i + 1 == count);
  readObjectEnd(reader, frame);
}

std::uint32_t readCount(ByteReader& reader, std::uint64_t bytesLeft) {
  const auto count = reader.get<std::uint32_t>();
  if (count > bytesLeft / (2 * kSmallestObject))
    refuse(reader.file(), "it is damaged: it claims " + std::to_string(count) + " entries",
           kSaveMapAgain);
  return count;
}

ObjectHeader readMapHeader(ByteReader& reader) {
  ObjectHeader header = readObjectHeader(reader);
  checkVersion(reader, header, 2);
  return header;
}

/** Compares what the first bytes claim with the size of the whole, which is not inflated yet. */
void checkHead(const CheckedFile& file) {
  constexpr std::uint64_t mostBytes = 1'000'000'000;
  ByteReader head(file.head(), file.name());
  readMapHeader(head);
  readCount(head, file.claimedSize());
  if (file.claimedSize() > mostBytes)
    refuse(file.name(), "is larger than 1 GB", "give a smaller map, or a gridmap");
}

void readEntries(ByteReader reader, Recording& recording) {
  const ObjectHeader map = readMapHeader(reader);
  recording.version = map.version;
  for (std::uint32_t left = readCount(reader, reader.left()); left > 0; --left) {
    const std::size_t begin = reader.position();
    recording.frames.emplace_back().robot = readPoseMean(reader);
    readFrame(reader, recording);
    if (map.version >= 2) skipTwist(reader);
    recording.frames.back().begin = begin, recording.frames.back().end = reader.position();
  }
  readObjectEnd(reader, map);
  if (reader.left() > 0)
    refuse(reader.file(), "something follows the map in it", "remove what was appended");
}

}  // namespace

bool isSimplemap(CheckedFile& file) {
  const auto object = peekObjectHeader(file.head());
  return object &&
         (object->className == "CSimpleMap" || object->className == "CSensFrameProbSequence");
}

Recording readSimplemap(CheckedFile& file) {
  if (!isSimplemap(file)) refuse(file.name(), "is no simplemap", "give one");
  checkHead(file);
  Recording recording;
  recording.file = file.name();
  recording.compression = file.compression();
  readEntries(ByteReader(file.content(), file.name()), recording);
  recording.sha256 = file.sha256();
  if (allOf(recording.frames, [](const Recording::Frame& frame) { return frame.clouds.empty(); }))
    file.release();
  return recording;
}

}  // namespace roomgraph
