#include "zstd_frame.h"

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>

namespace roomgraph {
namespace {

[[noreturn]] void refuseFrame(const std::string& file) {
  refuse(file, "its zstd data is cut short or damaged", "copy or save the map again");
}

}  // namespace

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
