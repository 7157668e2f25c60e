#include "roomgraph/base/zip_archive.h"

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace roomgraph {
namespace {

/** Numbers of a ZIP archive are little-endian. */
void add16(std::string& bytes, std::uint32_t value) {
  bytes += char(value & 0xFFu);
  bytes += char(value >> 8u & 0xFFu);
}

void add32(std::string& bytes, std::uint32_t value) {
  add16(bytes, value);
  add16(bytes, value >> 16u);
}

/** What the header of a file and its entry in the directory have in common. */
std::string entryOf(const std::string& name, const std::string& content) {
  constexpr std::uint32_t version = 20, namesAreUtf8 = 1u << 11u, stored = 0;
  constexpr std::uint32_t midnight = 0, firstDay = 1u << 5u | 1u;  // of 1980, the first there is
  std::string entry;
  for (const std::uint32_t value : {version, namesAreUtf8, stored, midnight, firstDay})
    add16(entry, value);
  add32(entry,
        std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size())));
  add32(entry, std::uint32_t(content.size()));  // compressed
  add32(entry, std::uint32_t(content.size()));  // and not
  add16(entry, std::uint32_t(name.size()));
  add16(entry, 0);  // no extra field
  return entry;
}

}  // namespace

std::string zipArchive(const std::vector<std::pair<std::string, std::string>>& files) {
  constexpr std::uint32_t local = 0x04034b50, central = 0x02014b50, end = 0x06054b50;
  std::string archive, directory;
  for (const auto& [name, content] : files) {
    const std::string entry = entryOf(name, content);
    add32(directory, central);
    add16(directory, 20);  // made by a program of version 2.0
    directory += entry;
    for (int i = 0; i < 3; ++i) add16(directory, 0);  // no comment, first disk, no attributes
    add32(directory, 0);
    add32(directory, std::uint32_t(archive.size()));
    directory += name;
    add32(archive, local);
    archive += entry + name + content;
  }
  if (files.size() > std::numeric_limits<std::uint16_t>::max() ||
      archive.size() + directory.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("the archive is larger than ZIP allows");
  const auto start = std::uint32_t(archive.size());
  archive += directory;
  add32(archive, end);
  add32(archive, 0);  // one disk
  for (int i = 0; i < 2; ++i) add16(archive, std::uint32_t(files.size()));
  add32(archive, std::uint32_t(directory.size()));
  add32(archive, start);
  add16(archive, 0);  // no comment
  return archive;
}

}  // namespace roomgraph
