#include "roomgraph/base/compressed.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace roomgraph {
namespace {

std::string asZstd(const std::string& bytes) {
  const std::unique_ptr<ZSTD_CCtx, size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                   ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size)) throw std::bad_alloc();  // there is room for all of it
  out.resize(size);
  return out;
}

[[noreturn]] void refuseFrame(const std::string& file) {
  refuse(file, "its zstd data is cut short or damaged", kSaveMapAgain);
}

}  // namespace

std::string gzipped(const std::string& bytes, const std::string& comment) {
  if (bytes.size() > std::numeric_limits<uInt>::max())
    throw std::length_error("the object is larger than 4 GB");
  z_stream stream{};
  // Maps and scenes compress nearly as well at the lowest level, in a third of the time.
  constexpr int gzipFrame = 16 + MAX_WBITS, memory = 8;
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, gzipFrame, memory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::bad_alloc();
  constexpr int unixSystem = 3;
  gz_header header{};
  header.os = unixSystem;
  header.comment = reinterpret_cast<Bytef*>(const_cast<char*>(comment.c_str()));
  if (!comment.empty()) deflateSetHeader(&stream, &header);
  std::string out(deflateBound(&stream, uLong(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);  // cannot fail: there is room for all of it
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string compressed(const std::string& bytes, Compression how) {
  if (how == Compression::none) return bytes;
  return how == Compression::gzip ? gzipped(bytes, {}) : asZstd(bytes);
}

bool isZstd(ByteView head) {
  constexpr std::uint8_t magic[] = {0x28, 0xb5, 0x2f, 0xfd};
  return head.size >= sizeof magic && std::equal(magic, std::end(magic), head.data);
}

ZstdContent readZstd(ByteView frame, std::size_t headSize, std::uint64_t most,
                     const std::string& file) {
  const std::unique_ptr<ZSTD_DStream, size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                        ZSTD_freeDStream);
  if (!stream) throw std::bad_alloc();
  ZstdContent content;
  std::vector<std::uint8_t> piece(ZSTD_DStreamOutSize());
  ZSTD_inBuffer in{frame.data, frame.size, 0};
  for (std::size_t left = 1; left != 0;) {
    ZSTD_outBuffer out{piece.data(), piece.size(), 0};
    left = ZSTD_decompressStream(stream.get(), &out, &in);
    const bool isStuck = out.pos == 0 && in.pos == in.size && left != 0;
    if (ZSTD_isError(left) || isStuck) refuseFrame(file);
    const std::size_t kept = std::min(out.pos, headSize - content.head.size());
    content.head.insert(content.head.end(), piece.data(), piece.data() + kept);
    content.size += out.pos;
    if (content.size > most)
      refuse(file, "inflates to more than " + std::to_string(most / 1'000'000'000) + " GB",
             "give a smaller map");
  }
  if (in.pos < in.size) refuse(file, "something follows its zstd data", "remove what was appended");
  return content;
}

void decompressZstd(ByteView frame, std::uint8_t* out, std::uint64_t size,
                    const std::string& file) {
  if (ZSTD_decompress(out, size, frame.data, frame.size) != size) refuseFrame(file);
}

}  // namespace roomgraph
