#include "as_file.h"

#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace roomgraph::test {
namespace {

namespace fs = std::filesystem;

/** Gone with the process, if that ends well. */
struct OwnFile {
  OwnFile() {
    const fs::path memory = "/dev/shm";
    const fs::path folder = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    name = (folder / ("roomgraph_fuzz_" + std::to_string(getpid()))).string();
  }
  ~OwnFile() { unlink(name.c_str()); }
  std::string name;
};

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(bytes[at + i]);
  return value;
}

uLong checksum(const char* bytes, std::size_t size) {
  return crc32(0, reinterpret_cast<const Bytef*>(bytes), uInt(size));
}

}  // namespace

const std::string& asFile(const std::string& bytes) {
  static const OwnFile file;
  std::ofstream out(file.name, std::ios::binary | std::ios::trunc);
  if (!(out << bytes << std::flush)) std::abort();
  return file.name;
}

std::string withPngChecksums(std::string bytes) {
  constexpr std::size_t kSignature = 8, kAround = 12;  // length, type and checksum of a chunk
  for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
    const std::size_t length = bigEndian(bytes, at);
    if (length > bytes.size() - at - kAround) break;
    const uLong sum = checksum(&bytes[at + 4], 4 + length);
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = char(sum >> (24 - 8 * i));
    at += kAround + length;
  }
  return bytes;
}

}  // namespace roomgraph::test
