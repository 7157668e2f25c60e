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

std::string inGzip(const std::string& bytes) {
  z_stream stream{};
  constexpr int kGzip = 16 + MAX_WBITS, kFastest = 1;
  if (deflateInit2(&stream, kFastest, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    std::abort();
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) std::abort();
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
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
