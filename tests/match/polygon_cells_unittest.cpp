#include "roomgraph/match/polygon_cells.h"

#include <gtest/gtest.h>

#include <string>

namespace roomgraph {
namespace {

const GridFrame kFrame{8, 5, 1, {}};

/** The cells drawn as '#', the highest row first. */
std::string picture(const std::vector<Cell>& cells) {
  std::vector<std::string> rows(std::size_t(kFrame.height), std::string(8, '.'));
  for (const Cell c : cells) rows[std::size_t(kFrame.height - 1 - c.y)][std::size_t(c.x)] = '#';
  std::string text;
  for (const std::string& row : rows) text += row + "\n";
  return text;
}

TEST(CellsIn, haveTheirCentreInThePolygon) {
  const Polygon box{{{1.4, 0.6}, {4.6, 0.6}, {4.6, 3}, {1.4, 3}}, {}};
  EXPECT_EQ(picture(cellsIn(box, kFrame)),
            "........\n"
            "........\n"
            ".####...\n"
            ".####...\n"
            "........\n");
}

TEST(CellsIn, leaveHolesOut) {
  const Polygon ring{{{0, 0}, {8, 0}, {8, 5}, {0, 5}}, {{{2, 1}, {2, 4}, {6, 4}, {6, 1}}}};
  EXPECT_EQ(picture(cellsIn(ring, kFrame)),
            "########\n"
            "##....##\n"
            "##....##\n"
            "##....##\n"
            "########\n");
}

TEST(CellsIn, slantedSidesCutCellsAtTheirCentres) {
  const Polygon triangle{{{0, 0}, {5, 0}, {0, 5}}, {}};
  const auto cells = cellsIn(triangle, kFrame);
  for (const Cell c : cells) EXPECT_LE(c.x + c.y, 4);
  EXPECT_GE(cells.size(), 10u);
}

TEST(CellsIn, endAtTheFrame) {
  const Polygon large{{{-9, -9}, {99, -9}, {99, 99}, {-9, 99}}, {}};
  EXPECT_EQ(cellsIn(large, kFrame).size(), kFrame.cellCount());
  EXPECT_TRUE(cellsIn({}, kFrame).empty());
}

}  // namespace
}  // namespace roomgraph
