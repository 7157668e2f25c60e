#pragma once
#include <cstdint>
#include <vector>

#include "roomgraph/base/byte_reader.h"

namespace roomgraph {

/** From how many bytes on content is first decompressed to nowhere: where it is damaged near its
 *  end, that costs no memory. */
constexpr std::uint64_t kProveFrom = 100'000'000;

enum class Deflated { asGzip, asZlib };

/** Whether the pieces, one after the other, are one whole stream of `size` bytes with the right
 *  checksum. No memory but 64 KiB; O(size). */
bool isWholeStream(const std::vector<ByteView>& pieces, Deflated kind, std::uint64_t size);

}  // namespace roomgraph
