#include "roomgraph/grid/checked_file.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>

namespace roomgraph {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeadSize = 1 << 16;
constexpr std::uint64_t kLargestFile = 2'000'000'000;
// No deflate stream grows by more than this.
constexpr std::uint64_t kMostInflation = 1032;

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
  refuse(file, "its gzip data is cut short or damaged", "copy or save the map again");
}

}  // namespace

void refuse(const std::string& file, const std::string& problem, const std::string& remedy) {
  std::string line = file + ": " + problem + ": " + remedy;
  // A file name may hold anything; the message must stay one line.
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  throw DataError(line);
}

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

CheckedFile::CheckedFile(const std::string& name) : name_(name) {
  std::error_code error;
  const fs::file_status status = fs::status(name, error);
  if (status.type() == fs::file_type::not_found)
    refuse(name, "there is no such file", "check the name");
  if (fs::is_directory(status)) refuse(name, "is a directory", "name the map file in it");
  if (!fs::is_regular_file(status)) refuse(name, "is no regular file", "give a map file");
  storedSize_ = fs::file_size(name, error);
  if (error) refuse(name, "its size cannot be read", "check its permissions");
  in_.open(name, std::ios::binary);
  if (!in_) refuse(name, "cannot be opened", "check its permissions");
  if (storedSize_ == 0) refuse(name, "is empty", "copy or save the map again");
  if (storedSize_ > kLargestFile) refuse(name, "is larger than 2 GB", "give a smaller map");
  readHead();
}

void CheckedFile::readHead() {
  head_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(storedSize_, kHeadSize)));
  in_.read(reinterpret_cast<char*>(head_.data()), std::streamsize(head_.size()));
  if (!in_) refuse(name_, "cannot be read", "check the disk and the permissions");
  claimedSize_ = storedSize_;
  isGzip_ = head_.size() >= 2 && head_[0] == 0x1f && head_[1] == 0x8b;
  if (!isGzip_) return;

  // 18 bytes are the shortest frame of a gzip member; its last four say how long the content is.
  if (storedSize_ < 18) refuseGzip(name_);
  std::uint8_t tail[4];
  in_.seekg(-4, std::ios::end);
  in_.read(reinterpret_cast<char*>(tail), sizeof tail);
  if (!in_) refuse(name_, "cannot be read", "check the disk and the permissions");
  claimedSize_ = ByteReader({tail, sizeof tail}, name_).get<std::uint32_t>();
  if (claimedSize_ / kMostInflation > storedSize_) refuseGzip(name_);
  if (claimedSize_ > kLargestFile)
    refuse(name_, "claims to inflate to more than 2 GB", "give a smaller map");

  std::vector<std::uint8_t> inflated(kHeadSize);
  Inflater inflater(head_.data(), head_.size(), inflated.data(), inflated.size());
  const int result = inflater.run(Z_SYNC_FLUSH);
  if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) refuseGzip(name_);
  inflated.resize(inflated.size() - inflater.outputLeft());
  head_ = std::move(inflated);
}

ByteView CheckedFile::content() {
  if (!stored_) {
    readStored();
    if (isGzip_) inflateAll();
  }
  if (isGzip_) return {content_.get(), static_cast<std::size_t>(claimedSize_)};
  return {stored_.get(), static_cast<std::size_t>(storedSize_)};
}

void CheckedFile::readStored() {
  const auto size = static_cast<std::size_t>(storedSize_);
  stored_.reset(new std::uint8_t[size]);
  in_.clear();
  in_.seekg(0);
  in_.read(reinterpret_cast<char*>(stored_.get()), std::streamsize(size));
  if (!in_) refuse(name_, "cannot be read to its end", "check the disk, or copy it again");
  sha256_ = sha256Of({stored_.get(), size});
}

void CheckedFile::inflateAll() {
  const auto size = static_cast<std::size_t>(claimedSize_);
  content_.reset(new std::uint8_t[size + 1]);  // one more: zlib refuses an empty output
  Inflater inflater(stored_.get(), static_cast<std::size_t>(storedSize_), content_.get(), size + 1);
  const bool isWhole = inflater.run(Z_FINISH) == Z_STREAM_END;
  if (isWhole && inflater.inputLeft() > 0)
    refuse(name_, "something follows its gzip data", "remove what was appended");
  if (!isWhole || inflater.outputLeft() != 1) refuseGzip(name_);
  if (size == 0) refuse(name_, "is empty", "copy or save the map again");
}

}  // namespace roomgraph
