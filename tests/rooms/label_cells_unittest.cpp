#include <gtest/gtest.h>

#include <string>

#include "label_areas.h"

namespace roomgraph {
namespace {

constexpr std::uint32_t kNone = Regions::kNone;

/** Free cells of 1 m whose centres have whole coordinates. */
Grid freeGrid(int width, int height) {
  return {{width, height, 1, {-0.5, -0.5}},
          std::vector<State>(std::size_t(width * height), State::free)};
}

/** The labels as rows of digits, the highest first. */
std::string picture(const Grid& grid, const std::vector<std::uint16_t>& labels) {
  std::string text;
  for (int y = grid.frame.height - 1; y >= 0; --y) {
    for (int x = 0; x < grid.frame.width; ++x)
      text += std::to_string(labels[grid.frame.index({x, y})]);
    text += '\n';
  }
  return text;
}

/** Two regions side by side, that meet at x = 2; walls at x = 0 and x = 5. */
std::vector<RegionBorder> sideBySide() {
  return {{kNone, 0, {0, 0}, {0, 3}, 0}, {0, 1, {2, 0}, {2, 3}, 1}, {1, kNone, {5, 0}, {5, 3}, 0}};
}

TEST(LabelCells, partsTheCellsAtTheBorders) {
  const Grid grid = freeGrid(6, 3);
  const std::vector<AreaId> areaOf{AreaId(0), AreaId(1)};
  EXPECT_EQ(picture(grid, labelCells(grid, sideBySide(), areaOf)), "112220\n112220\n112220\n");
}

TEST(LabelCells, aBorderMayRunEitherWay) {
  const Grid grid = freeGrid(6, 3);
  std::vector<RegionBorder> borders = sideBySide();
  for (RegionBorder& border : borders) {
    std::swap(border.from, border.to);
    std::swap(border.left, border.right);
  }
  const std::vector<AreaId> areaOf{AreaId(0), AreaId(1)};
  EXPECT_EQ(picture(grid, labelCells(grid, borders, areaOf)), "112220\n112220\n112220\n");
}

TEST(LabelCells, onlyFreeCellsHaveALabel) {
  Grid grid = freeGrid(6, 3);
  grid.cells[grid.frame.index({1, 1})] = State::occupied;
  grid.cells[grid.frame.index({3, 0})] = State::unknown;
  const std::vector<AreaId> areaOf{AreaId(0), AreaId(1)};
  EXPECT_EQ(picture(grid, labelCells(grid, sideBySide(), areaOf)), "112220\n102220\n112020\n");
}

TEST(LabelCells, aRegionInNoAreaHasNoLabel) {
  const Grid grid = freeGrid(6, 3);
  EXPECT_EQ(picture(grid, labelCells(grid, sideBySide(), {AreaId::none(), AreaId(0)})),
            "001110\n001110\n001110\n");
}

TEST(LabelCells, bordersMaySlant) {
  const Grid grid = freeGrid(5, 4);
  const std::vector<RegionBorder> borders{
      {kNone, 0, {0, 0}, {0, 4}, 0}, {0, 1, {0, 0}, {4, 4}, 1}, {1, kNone, {4, 0}, {4, 4}, 0}};
  EXPECT_EQ(picture(grid, labelCells(grid, borders, {AreaId(0), AreaId(1)})),
            "11120\n11220\n12220\n22220\n");
}

}  // namespace
}  // namespace roomgraph
