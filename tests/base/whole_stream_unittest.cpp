#include <gtest/gtest.h>

#include "map_files.h"
#include "roomgraph/base/compressed.h"

namespace roomgraph::test {
namespace {

ByteView viewOf(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

bool isWhole(const std::string& bytes, std::uint64_t size) {
  return isWholeStream({viewOf(bytes)}, Deflated::asGzip, size);
}

TEST(WholeStream, isOneOfThatSizeInHoweverManyPieces) {
  const std::string packed = gzipped(std::string(1'000'000, 'x') + "end");
  EXPECT_TRUE(isWhole(packed, 1'000'003));
  EXPECT_FALSE(isWhole(packed, 1'000'002));
  EXPECT_FALSE(isWhole(packed, 1'000'004));
  std::vector<ByteView> bytes;
  for (std::size_t i = 0; i < packed.size(); ++i) bytes.push_back({viewOf(packed).data + i, 1});
  bytes.push_back({});
  EXPECT_TRUE(isWholeStream(bytes, Deflated::asGzip, 1'000'003));
  EXPECT_FALSE(isWholeStream(bytes, Deflated::asZlib, 1'000'003));
  EXPECT_TRUE(isWhole(gzipped(""), 0));
}

TEST(WholeStream, isNoneThatIsCutDamagedOrFollowedByMore) {
  const std::string packed = gzipped(std::string(300'000, 'x') + "end");
  for (std::size_t end = 0; end < packed.size(); ++end)
    EXPECT_FALSE(isWhole(packed.substr(0, end), 300'003)) << end;
  for (std::size_t at = 10; at < packed.size(); ++at) {  // behind the head, which has no checksum
    std::string damaged = packed;
    damaged[at] = char(damaged[at] ^ 1);
    EXPECT_FALSE(isWhole(damaged, 300'003)) << at;
  }
  EXPECT_FALSE(isWhole(packed + "x", 300'003));
  EXPECT_FALSE(isWhole("", 0));
}

}  // namespace
}  // namespace roomgraph::test
