#include "roomgraph/breaks/place_break.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Scans along a wall that is `y` away, one metre apart; from `torn` on that wall is drawn 2 m too
 *  far off. */
std::vector<ScanWalls> scansAlongAWall(std::size_t torn) {
  std::vector<ScanWalls> scans(20);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const double y = k >= torn ? 4 : 2;
    scans[k].pose = {double(k), y - 2, 0};
    for (int i = -40; i <= 40; ++i) scans[k].walls.push_back({{double(k) + 0.1 * i, y}, {0, -1}});
  }
  return scans;
}

std::vector<bool> allSeenBut(std::size_t first, std::size_t last) {
  std::vector<bool> isSeen(20, true);
  for (std::size_t k = first; k <= last; ++k) isSeen[k] = false;
  return isSeen;
}

TEST(PlaceBreak, amongScansThatNobodyElseHasSeenItIsWhereTwoDisagree) {
  const auto scans = scansAlongAWall(10);
  EXPECT_EQ(placeBreak(scans, allSeenBut(7, 9), 7), 10u);
  EXPECT_EQ(placeBreak(scans, allSeenBut(7, 9), 8), 10u);
  EXPECT_EQ(placeBreak(scans, allSeenBut(10, 12), 13), 10u);
}

TEST(PlaceBreak, whereOthersHaveSeenTheScansTheConsensusIsRight) {
  EXPECT_EQ(placeBreak(scansAlongAWall(10), allSeenBut(7, 8), 7), 7u) << "the ninth was seen";
  EXPECT_EQ(placeBreak(scansAlongAWall(10), std::vector<bool>(20, true), 9), 9u);
}

TEST(PlaceBreak, staysWhereNothingTellsOtherwise) {
  EXPECT_EQ(placeBreak(scansAlongAWall(99), allSeenBut(7, 9), 8), 8u);
  EXPECT_EQ(placeBreak(std::vector<ScanWalls>(20), allSeenBut(0, 19), 8), 8u);
}

TEST(PlaceBreak, looksNoFartherThanFiveScans) {
  EXPECT_EQ(placeBreak(scansAlongAWall(16), allSeenBut(5, 19), 8), 8u);
}

}  // namespace
}  // namespace roomgraph
