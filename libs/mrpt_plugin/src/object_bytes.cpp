#include "object_bytes.h"

#include <mrpt/io/CMemoryStream.h>

#include <algorithm>
#include <stdexcept>

#include "roomgraph/base/compressed.h"
#include "roomgraph/scans/object_header.h"

namespace roomgraph {
namespace {

/** Reads what the stream claims to hold piece by piece: a false claim costs no memory. */
std::string readClaimed(mrpt::serialization::CArchive& reader, std::uint64_t size) {
  constexpr std::uint64_t pieceSize = 1 << 20;
  std::string bytes;
  while (bytes.size() < size) {
    const auto piece = static_cast<std::size_t>(std::min(size - bytes.size(), pieceSize));
    bytes.resize(bytes.size() + piece);
    if (reader.ReadBuffer(bytes.data() + bytes.size() - piece, piece) != piece)
      throw std::runtime_error("end of stream");
  }
  return bytes;
}

}  // namespace

std::string objectBytes(const mrpt::serialization::CSerializable& object) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()),
          std::size_t(stream.getTotalBytesCount())};
}

std::string gzippedObject(const mrpt::serialization::CSerializable& object) {
  return compressed(objectBytes(object), Compression::gzip);
}

void putBody(mrpt::serialization::CArchive& out, const std::string& bytes) {
  out << static_cast<std::uint64_t>(bytes.size());
  out.WriteBuffer(bytes.data(), bytes.size());
}

void readBody(mrpt::serialization::CArchive& reader, std::uint8_t version, const ObjectKind& kind,
              const std::function<void(ByteView)>& read) {
  if (version > kind.newest)
    refuse(kind.name, "its version " + std::to_string(version) + " is not known",
           "read it with a newer roomgraph");
  std::string bytes;
  try {
    bytes = readClaimed(reader, reader.ReadAs<std::uint64_t>());
  } catch (const std::exception&) {
    // MRPT's own message is a page with a backtrace.
    refuse(kind.name, "it is cut short or damaged", "copy or save it again");
  }
  read({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

void readObjectFile(const std::string& path, const ObjectKind& kind,
                    const std::function<void(ByteView)>& read) {
  CheckedFile file(path);
  const std::optional<ObjectHeader> head = peekObjectHeader(file.head());
  if (!head || head->className != kind.className)
    refuse(path, std::string("is not a ") + kind.name, kind.remedy);
  ByteReader reader(file.content(), path);
  const ObjectHeader header = readObjectHeader(reader);
  checkVersion(reader, header, kind.newest);
  const auto size = reader.get<std::uint64_t>();
  const ByteView body{reader.take(size), static_cast<std::size_t>(size)};
  readObjectEnd(reader, header);
  if (reader.left() > 0)
    refuse(path, std::string("something follows the ") + kind.name + " in it", "save it again");
  read(body);
}

}  // namespace roomgraph
