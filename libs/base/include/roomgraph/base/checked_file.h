#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/byte_reader.h"
#include "roomgraph/base/enum_names.h"

namespace roomgraph {

/** A map may have at most this many cells. */
constexpr std::uint64_t kMostCells = 400'000'000;

// What to do about a file that is damaged.
constexpr const char* kSavePictureAgain = "copy or save the picture again";
constexpr const char* kSaveMapAgain = "copy or save the map again";

enum class Compression { none, gzip, zstd };  ///< of a file
[[nodiscard]] constexpr std::array<const char*, 3> enumNames(Compression) {
  return {"none", "gzip", "zstd"};
}

/** A file whose bytes can be trusted to be those that were written: compressed files are inflated
 *  with their length and checksum verified (zstd need not have one). But for zstd, reads no more
 *  than it is asked for, so that a file of the wrong kind costs nothing. */
class CheckedFile {
 public:
  /** Opens the file and reads its first bytes. Throws DataError where that is impossible. */
  explicit CheckedFile(const std::string& name);

  const std::string& name() const { return file_.name(); }  ///< as the caller gave it
  /** The first bytes of the (inflated) content, at most 64 KiB; not verified yet. */
  [[nodiscard]] ByteView head() const { return {head_.data(), head_.size()}; }
  [[nodiscard]] Compression compression() const { return compression_; }  ///< of the file
  /** How long the content claims to be. */
  [[nodiscard]] std::uint64_t claimedSize() const { return claimedSize_; }
  /** All of the content, verified; stays valid as long as this object, or until release(). */
  ByteView content();
  /** Gives the memory of the content back. */
  void release() { content_.reset(), stored_.reset(); }
  /** Of the stored bytes, lower-case hex; empty before content(). */
  const std::string& sha256() const { return sha256_; }

 private:
  void readHead();
  void readStored();
  [[nodiscard]] ByteView stored() const;
  void readGzipHead();
  void readZstdHead();
  void inflateGzip();
  void inflateZstd();

  InputFile file_;
  std::uint64_t claimedSize_ = 0;
  Compression compression_ = Compression::none;
  std::vector<std::uint8_t> head_;
  // Plain arrays: a vector would write to every byte before the first one is read.
  std::unique_ptr<std::uint8_t[]> stored_, content_;
  std::string sha256_;
};

/** Lower-case hex of the SHA-256 of `first` followed by `second`. */
[[nodiscard]] std::string sha256Of(ByteView first, ByteView second = {});

}  // namespace roomgraph
