#include "MaskCells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

RosMapYaml yamlOf(const std::string& mode, double free, double occupied, bool negate = false) {
  RosMapYaml yaml;
  yaml.mode = mode, yaml.freeBelow = free, yaml.occupiedAbove = occupied, yaml.negate = negate;
  return yaml;
}

TEST(MaskCells, greysMarkAsNav2ReadsThem) {
  const MaskGreys trinary(yamlOf("trinary", 0.196, 0.65)), scale(yamlOf("scale", 0, 1)),
      raw(yamlOf("raw", 0, 1)), negated(yamlOf("scale", 0, 1, true));
  EXPECT_EQ(trinary.mark(0), 100);
  EXPECT_FALSE(trinary.isMarked(205));  // unknown
  EXPECT_FALSE(trinary.isMarked(254));
  EXPECT_EQ(scale.mark(128), 49);
  EXPECT_FALSE(scale.isMarked(255));
  EXPECT_EQ(raw.mark(30), 30);
  EXPECT_FALSE(raw.isMarked(255));  // unknown
  EXPECT_EQ(negated.mark(128), 50);
  for (const MaskGreys& greys : {trinary, scale, raw, negated})
    EXPECT_EQ(greys.mark(greys.free()), 0);
}

TEST(MaskCells, cellsThatTouchAtACornerAreOneRegion) {
  GridFrame frame;
  frame.width = 4, frame.height = 3, frame.resolution = 1;
  std::vector<bool> isMarked(12);
  for (const std::size_t cell : {0, 5, 3, 11}) isMarked[cell] = true;
  EXPECT_EQ(maskRegions(frame, isMarked), (std::vector<MaskRegion>{{0, 5}, {3}, {11}}));
}

TEST(MaskCells, neighbouringCellsLeaveNoGapHoweverTheyAreTurned) {
  GridFrame frame;
  frame.width = frame.height = 40, frame.resolution = 1, frame.origin = {-20, -20};
  for (const double turn : {0.0, 0.3, 0.785398, 1.2, 2.9}) {
    const Transform2D motion{0.3, 0.1, turn};
    std::vector<bool> isCovered(frame.cellCount());
    for (int x = -8; x < 8; ++x)
      for (int y = -8; y < 8; ++y) {
        const Point at{double(x), double(y)};
        const auto cells = cellsIn(frame, {motion(at), motion(at + Point{1, 0}),
                                           motion(at + Point{1, 1}), motion(at + Point{0, 1})});
        ASSERT_FALSE(cells.empty());
        for (const Cell cell : cells) isCovered[frame.index(cell)] = true;
      }
    for (std::size_t i = 0; i < isCovered.size(); ++i) {
      const Point p = motion.inverse()(frame.center({int(i) % 40, int(i) / 40}));
      if (std::max(std::abs(p.x), std::abs(p.y)) < 8 - 1e-9) {
        EXPECT_TRUE(isCovered[i]) << turn << " " << p.x << " " << p.y;
      }
    }
  }
}

}  // namespace
}  // namespace roomgraph
