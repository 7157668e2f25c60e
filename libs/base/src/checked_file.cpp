#include "roomgraph/base/checked_file.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>

#include "roomgraph/base/compressed.h"

namespace roomgraph {
namespace {

constexpr std::size_t kHeadSize = 1 << 16;
constexpr std::uint64_t kLargestFile = 2'000'000'000;

/** zlib's inflater for one gzip member; it checks length and checksum at the end. */
class Inflater {
 public:
  Inflater(const std::uint8_t* in, std::size_t inSize, std::uint8_t* out, std::size_t outSize) {
    stream_.next_in = const_cast<Bytef*>(in);
    stream_.avail_in = static_cast<uInt>(inSize);
    stream_.next_out = out;
    stream_.avail_out = static_cast<uInt>(outSize);
    constexpr int gzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzipOnly) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  int run(int flush) { return inflate(&stream_, flush); }
  std::size_t inputLeft() const { return stream_.avail_in; }
  std::size_t outputLeft() const { return stream_.avail_out; }

 private:
  z_stream stream_{};
};

[[noreturn]] void refuseGzip(const std::string& file) {
  refuse(file, "its gzip data is cut short or damaged", kSaveMapAgain);
}

}  // namespace

std::string sha256Of(ByteView first, ByteView second) {
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free);
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int length = 0;
  if (!context || !EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) ||
      !EVP_DigestUpdate(context.get(), first.data, first.size) ||
      !EVP_DigestUpdate(context.get(), second.data, second.size) ||
      !EVP_DigestFinal_ex(context.get(), digest, &length))
    throw std::runtime_error("SHA-256 is not available in this build of OpenSSL");
  std::string hex;
  for (unsigned int i = 0; i < length; ++i) {
    hex += "0123456789abcdef"[digest[i] >> 4];
    hex += "0123456789abcdef"[digest[i] & 15];
  }
  return hex;
}

CheckedFile::CheckedFile(const std::string& name) : file_(name, kLargestFile) {
  if (file_.size() == 0) refuse(name, "is empty", kSaveMapAgain);
  readHead();
}

void CheckedFile::readHead() {
  head_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(file_.size(), kHeadSize)));
  file_.read(0, head_.data(), head_.size());
  claimedSize_ = file_.size();
  if (head_.size() >= 2 && head_[0] == 0x1f && head_[1] == 0x8b)
    readGzipHead();
  else if (isZstd(head()))
    readZstdHead();
}

void CheckedFile::readZstdHead() {
  compression_ = Compression::zstd;
  readStored();
  ZstdContent content = readZstd(stored(), kHeadSize, kLargestFile, name());
  head_ = std::move(content.head);
  claimedSize_ = content.size;
}

void CheckedFile::readGzipHead() {
  compression_ = Compression::gzip;
  // 18 bytes are the shortest frame of a gzip member; its last four say how long the content is.
  if (file_.size() < 18) refuseGzip(name());
  std::uint8_t tail[4];
  file_.read(file_.size() - sizeof tail, tail, sizeof tail);
  claimedSize_ = ByteReader({tail, sizeof tail}, name()).get<std::uint32_t>();
  // No deflate stream grows by more than that.
  if (claimedSize_ / kMostInflation > file_.size()) refuseGzip(name());
  if (claimedSize_ > kLargestFile)
    refuse(name(), "claims to inflate to more than 2 GB", "give a smaller map");

  std::vector<std::uint8_t> inflated(kHeadSize);
  Inflater inflater(head_.data(), head_.size(), inflated.data(), inflated.size());
  const int result = inflater.run(Z_SYNC_FLUSH);
  if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) refuseGzip(name());
  inflated.resize(inflated.size() - inflater.outputLeft());
  head_ = std::move(inflated);
}

ByteView CheckedFile::stored() const {
  return {stored_.get(), static_cast<std::size_t>(file_.size())};
}

ByteView CheckedFile::content() {
  if (!stored_) readStored();
  if (compression_ == Compression::none) return stored();
  if (!content_) {
    if (compression_ == Compression::gzip)
      inflateGzip();
    else
      inflateZstd();
  }
  return {content_.get(), static_cast<std::size_t>(claimedSize_)};
}

void CheckedFile::readStored() {
  const auto size = static_cast<std::size_t>(file_.size());
  stored_.reset(new std::uint8_t[size]);
  file_.read(0, stored_.get(), size);
  sha256_ = sha256Of({stored_.get(), size});
}

void CheckedFile::inflateZstd() {
  content_.reset(new std::uint8_t[static_cast<std::size_t>(claimedSize_)]);
  decompressZstd(stored(), content_.get(), claimedSize_, name());
}

void CheckedFile::inflateGzip() {
  const auto size = static_cast<std::size_t>(claimedSize_);
  content_.reset(new std::uint8_t[size + 1]);  // one more: zlib refuses an empty output
  Inflater inflater(stored_.get(), static_cast<std::size_t>(file_.size()), content_.get(),
                    size + 1);
  const bool isWhole = inflater.run(Z_FINISH) == Z_STREAM_END;
  if (isWhole && inflater.inputLeft() > 0)
    refuse(name(), "something follows its gzip data", "remove what was appended");
  if (!isWhole || inflater.outputLeft() != 1) refuseGzip(name());
  if (size == 0) refuse(name(), "is empty", kSaveMapAgain);
}

}  // namespace roomgraph
