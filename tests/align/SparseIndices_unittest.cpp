#include "roomgraph/align/SparseIndices.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

constexpr std::uint32_t kNone = kNoIndex;

void expectHolds(const std::vector<std::uint32_t>& cells) {
  const SparseIndices sparse(cells);
  ASSERT_EQ(sparse.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_EQ(sparse[i], cells[i]) << i;
}

TEST(SparseIndices, holdEachIndexAsItWas) {
  expectHolds({});
  expectHolds({kNone, kNone});
  std::vector<std::uint32_t> cells(100, kNone);
  cells[3] = 0, cells[50] = 65534, cells[99] = 7;
  expectHolds(cells);
}

TEST(SparseIndices, whatNeedsMoreThan16BitsIsHeldAsWell) {
  for (const std::uint32_t large : {65535u, 65536u, kNone - 1}) {
    std::vector<std::uint32_t> cells(100, kNone);
    cells[3] = 65534, cells[50] = large;
    expectHolds(cells);
  }
}

}  // namespace
}  // namespace roomgraph
