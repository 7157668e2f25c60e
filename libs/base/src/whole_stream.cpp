#include "roomgraph/base/whole_stream.h"

#include <zlib.h>

#include <new>

namespace roomgraph {
namespace {

/** zlib's state, and room for what comes out of it. */
class Sink {
 public:
  explicit Sink(Deflated kind) : buffer_(1 << 16) {
    const int window = kind == Deflated::asGzip ? 16 + MAX_WBITS : MAX_WBITS;
    if (inflateInit2(&stream_, window) != Z_OK) throw std::bad_alloc();
  }
  ~Sink() { inflateEnd(&stream_); }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  /** zlib's answer to the last of the bytes. */
  int take(ByteView bytes) {
    stream_.next_in = const_cast<Bytef*>(bytes.data);
    stream_.avail_in = uInt(bytes.size);
    int result = Z_OK;
    do {
      stream_.next_out = buffer_.data();
      stream_.avail_out = uInt(buffer_.size());
      result = inflate(&stream_, Z_NO_FLUSH);
      count_ += buffer_.size() - stream_.avail_out;
    } while (result == Z_OK && (stream_.avail_in > 0 || stream_.avail_out == 0));
    // All of a piece is used up, and the rest of the stream stands in the next one.
    return result == Z_BUF_ERROR && stream_.avail_in == 0 ? Z_OK : result;
  }
  bool hasTakenAll() const { return stream_.avail_in == 0; }
  std::uint64_t count() const { return count_; }

 private:
  z_stream stream_{};
  std::vector<Bytef> buffer_;
  std::uint64_t count_ = 0;
};

}  // namespace

bool isWholeStream(const std::vector<ByteView>& pieces, Deflated kind, std::uint64_t size) {
  Sink sink(kind);
  int result = Z_OK;
  for (const ByteView piece : pieces) {
    if (piece.size == 0) continue;
    if (result != Z_OK) return false;  // something follows the stream
    result = sink.take(piece);
  }
  return result == Z_STREAM_END && sink.hasTakenAll() && sink.count() == size;
}

}  // namespace roomgraph
