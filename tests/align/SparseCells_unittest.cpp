#include "roomgraph/align/SparseCells.h"

#include <gtest/gtest.h>

#include <numeric>

namespace roomgraph {
namespace {

void expectHolds(const std::vector<int>& cells, int usual) {
  const SparseCells<int> sparse(cells, usual);
  ASSERT_EQ(sparse.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_EQ(sparse[i], cells[i]) << i;
}

TEST(SparseCells, holdEachCellAsItWas) {
  std::vector<int> cells(1000, 7);
  expectHolds(cells, 7);
  expectHolds(cells, 0);
  for (const std::size_t at : {0u, 15u, 16u, 500u, 999u}) cells[at] = int(at) + 10;
  expectHolds(cells, 7);
  std::iota(cells.begin(), cells.end(), 0);
  expectHolds(cells, 7);
}

TEST(SparseCells, anyNumberOfCellsFits) {
  for (std::size_t size = 0; size < 40; ++size) {
    std::vector<int> cells(size, 1);
    if (size > 0) cells.back() = 2;
    expectHolds(cells, 1);
  }
  EXPECT_EQ(SparseCells<int>().size(), 0u);
}

}  // namespace
}  // namespace roomgraph
