#include "roomgraph/scans/object_header.h"

#include "roomgraph/base/checked_file.h"

namespace roomgraph {
namespace {

bool isNameByte(std::uint8_t c) { return std::isalnum(c) || c == '_' || c == ':'; }

}  // namespace

bool startsWithOptional(ByteView bytes) {
  constexpr char text[] = "std::optional";
  constexpr std::uint32_t length = sizeof text - 1;
  return bytes.size >= sizeof length + length &&
         std::memcmp(bytes.data, &length, sizeof length) == 0 &&
         std::memcmp(bytes.data + sizeof length, text, length) == 0;
}

std::optional<ObjectHeader> peekObjectHeader(ByteView bytes) {
  if (bytes.size < 2) return std::nullopt;
  ObjectHeader header;
  header.isOldFormat = (bytes.data[0] & 0x80) == 0;
  const std::size_t length = bytes.data[0] & 0x7f;
  const std::size_t start = header.isOldFormat ? 4 : 1;
  if (length == 0 || length > 120 || bytes.size < start + length) return std::nullopt;
  for (std::size_t i = 1; i < start; ++i)
    if (bytes.data[i] != 0) return std::nullopt;
  for (std::size_t i = 0; i < length; ++i)
    if (!isNameByte(bytes.data[start + i])) return std::nullopt;
  header.className.assign(reinterpret_cast<const char*>(bytes.data + start), length);
  const auto colon = header.className.rfind(':');
  if (colon != std::string::npos) header.className.erase(0, colon + 1);
  return header;
}

ObjectHeader readObjectHeader(ByteReader& reader) {
  auto header = peekObjectHeader({reader.peek(), reader.left()});
  if (!header) {
    reader.skip(1);  // tells a file that ends here from one that goes on with something else
    refuse(reader.file(), "it is cut short or damaged", kSaveMapAgain);
  }
  reader.skip((header->isOldFormat ? 4 : 1) + (reader.peek()[0] & 0x7f));
  if (header->className == "nullptr") return *header;
  header->version = header->isOldFormat ? reader.get<std::int32_t>() : reader.get<std::int8_t>();
  return *header;
}

void readObjectEnd(ByteReader& reader, const ObjectHeader& header) {
  if (!header.isOldFormat && reader.get<std::uint8_t>() != kObjectEnd)
    refuse(reader.file(),
           "it is damaged: a " + header.className + " in it does not end where it should",
           kSaveMapAgain);
}

void skipObject(ByteReader& reader, const std::function<bool(ByteView)>& follows) {
  while (reader.left() > 0) {
    const void* end = std::memchr(reader.peek(), kObjectEnd, reader.left());
    if (!end) break;
    reader.skip(std::uint64_t(static_cast<const std::uint8_t*>(end) - reader.peek()) + 1);
    if (follows({reader.peek(), reader.left()})) return;
  }
  refuse(reader.file(), "it is cut short or damaged", kSaveMapAgain);
}

void checkVersion(const ByteReader& reader, const ObjectHeader& header, int newest) {
  if (header.version < 0 || header.version > newest)
    refuse(reader.file(),
           "holds version " + std::to_string(header.version) + " of " + header.className +
               ", and only " + (newest == 0 ? "0 is" : "0 to " + std::to_string(newest) + " are") +
               " known here",
           "get a newer roomgraph, or give the map's grid as a ROS map (yaml with png)");
}

}  // namespace roomgraph
