#include "roomgraph/grid/polygon_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "RandomNumbers.h"

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

TEST(CellsIn, areThoseWhoseCentresLieInside) {
  test::RandomNumbers random(5);
  const GridFrame frame{60, 40, 0.25, {-7, -5}};
  for (int i = 0; i < 20; ++i) {
    Polygon star;  // ragged, and in places beyond the frame
    const Point middle = random.place(4);
    for (int k = 0; k < 200; ++k) {
      const double angle = 2 * M_PI * k / 200, far = random.between(1, 7);
      star.outer.push_back(middle + far * Point{std::cos(angle), std::sin(angle)});
    }
    std::size_t next = 0;
    const std::vector<Cell> cells = cellsIn(star, frame);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const bool isNext = next < cells.size() && cells[next].x == x && cells[next].y == y;
        EXPECT_EQ(sideOf(star, frame.center({x, y})) == Side::inside, isNext) << x << " " << y;
        next += isNext ? 1 : 0;
      }
    EXPECT_EQ(next, cells.size());
  }
}

}  // namespace
}  // namespace roomgraph
