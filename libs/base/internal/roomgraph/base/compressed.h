#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "roomgraph/base/byte_reader.h"
#include "roomgraph/base/checked_file.h"

namespace roomgraph {

/** The bytes as a file holds them: as they are, as one gzip member without a time stamp, or as one
 *  zstd frame with size and checksum. CheckedFile reads them back. Same bytes, same file. O(bytes).
 *  @throws std::length_error for more than 4 GB as gzip. */
std::string compressed(const std::string& bytes, Compression how);

/** The comment of gzip files that have no other place to name their author: whoever finds none has
 *  a file that is somebody else's. */
constexpr char kGzipMark[] = "Written by roomgraph.";

/** The same as gzip, with a comment in the header, where no reader of the content meets it. */
std::string gzipped(const std::string& bytes, const std::string& comment);

/** So many bytes come out of one of deflated data at most. */
constexpr std::uint64_t kMostInflation = 1032;

bool isZstd(ByteView head);

/** What a Zstandard frame holds, found out by decompressing it: its header need not say. */
struct ZstdContent {
  std::uint64_t size = 0;
  std::vector<std::uint8_t> head;  ///< the first bytes, at most as many as were asked for
};

/** Decompresses all of it and keeps the head only. Throws DataError where it is damaged (its
 *  checksum included, if it has one), followed by something, or holds more than `most` bytes. */
ZstdContent readZstd(ByteView frame, std::size_t headSize, std::uint64_t most,
                     const std::string& file);
/** Decompresses what readZstd() has checked to `out`, which has room for its size. */
void decompressZstd(ByteView frame, std::uint8_t* out, std::uint64_t size, const std::string& file);

}  // namespace roomgraph
