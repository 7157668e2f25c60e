#include "consensus_rooms.h"

#include <gtest/gtest.h>

#include <set>

#include "drawn_areas.h"

namespace roomgraph::test {
namespace {

using Rows = std::vector<std::string>;

ConsensusRooms consensusOf(const std::vector<RunAreas>& runs) {
  return consensusRooms({frameOf(threeRooms()), runs}, {}, oneByOne);
}

/** How many rooms hold the place. */
std::size_t roomsAt(const ConsensusRooms& consensus, Point p) {
  std::size_t count = 0;
  for (const SiteShape& room : consensus.rooms.shapes)
    count += sideOf(room.polygon, p) == Side::inside;
  return count;
}

const Point kBelow{7, 1.5}, kBesideIt{10, 1.5}, kTop{8, 6.5};

/** The drawing with another room right of the lowest one. */
Rows withAnotherRoom() {
  Rows rows = threeRooms();
  for (std::size_t y = 11; y < 15; ++y) rows[y].replace(19, 3, "EEE");
  return rows;
}

/** The drawing with the upper room in two. */
Rows withASplitRoom() {
  Rows rows = threeRooms();
  for (std::size_t y = 1; y < 5; ++y) rows[y].replace(16, 5, "EEEEE");
  return rows;
}

TEST(ConsensusRooms, equalRunsAgreeOnAll) {
  const RunAreas run = drawnAreas(threeRooms(), threeDoors());
  const ConsensusRooms consensus = consensusOf({run, run, run});
  ASSERT_EQ(consensus.rooms.shapes.size(), 4u);
  ASSERT_EQ(consensus.sources.size(), 4u);
  ASSERT_EQ(consensus.matches.size(), 3u);
  std::set<std::size_t> areas;
  for (std::size_t s = 0; s < 4; ++s) {
    areas.insert(consensus.sources[s].area);
    for (const auto& inRun : consensus.matches)
      EXPECT_EQ(inRun[s].areas, std::vector<std::size_t>{consensus.sources[s].area});
  }
  EXPECT_EQ(areas.size(), 4u);
}

TEST(ConsensusRooms, doorsMakeNeighbours) {
  const RunAreas run = drawnAreas(threeRooms(), threeDoors());
  const ConsensusRooms consensus = consensusOf({run, run});
  for (std::size_t s = 0; s < 4; ++s)
    for (std::size_t t = 0; t < 4; ++t) {
      const auto& neighbours = consensus.rooms.neighbours[s];
      EXPECT_EQ(std::count(neighbours.begin(), neighbours.end(), t) > 0,
                run.isOpenTo(consensus.sources[s].area, consensus.sources[t].area));
    }
}

TEST(ConsensusRooms, theMajorityDecidesWhetherARoomIsOneOrTwo) {
  const RunAreas whole = drawnAreas(threeRooms()), split = drawnAreas(withASplitRoom());
  EXPECT_EQ(consensusOf({whole, whole, split}).rooms.shapes.size(), 4u);
  EXPECT_EQ(consensusOf({whole, split, split}).rooms.shapes.size(), 5u);
}

TEST(ConsensusRooms, aRoomThatOneFairRunHasIsARoomToo) {
  const RunAreas without = drawnAreas(threeRooms());
  const ConsensusRooms fair = consensusOf({without, without, drawnAreas(withAnotherRoom())});
  EXPECT_EQ(roomsAt(fair, kBesideIt), 1u);
  EXPECT_FALSE(fair.matches[0].back().isMatched());
  EXPECT_TRUE(fair.matches[2].back().isMatched());
}

TEST(ConsensusRooms, aRunOfLittleTrustAddsNone) {
  const RunAreas without = drawnAreas(threeRooms());
  const RunAreas poor = drawnAreas(withAnotherRoom(), {}, 0.1);
  EXPECT_EQ(roomsAt(consensusOf({without, without, poor}), kBesideIt), 0u);
  EXPECT_EQ(roomsAt(consensusOf({without, without, poor, poor}), kBesideIt), 1u) << "but two do";
}

TEST(ConsensusRooms, neitherOneBelowASquareMetreNorAGapIsARoom) {
  Rows rows = threeRooms();
  rows[12].replace(19, 1, "E");         // a quarter of a square metre
  rows[14].replace(0, 9, "fffffffff");  // a slit of 4.5 m by 0.5 m
  const RunAreas run = drawnAreas(rows);
  EXPECT_EQ(consensusOf({run, run}).rooms.shapes.size(), 4u);
}

TEST(ConsensusRooms, theOrderOfTheRunsDoesNotMatter) {
  const RunAreas a = drawnAreas(threeRooms(), {}, 1), b = drawnAreas(withASplitRoom(), {}, 0.9),
                 c = drawnAreas(withAnotherRoom(), {}, 0.8);
  const ConsensusRooms forth = consensusOf({a, b, c}), back = consensusOf({c, b, a});
  ASSERT_EQ(forth.rooms.shapes.size(), back.rooms.shapes.size());
  for (std::size_t s = 0; s < forth.rooms.shapes.size(); ++s)
    EXPECT_EQ(forth.rooms.shapes[s].polygon.outer, back.rooms.shapes[s].polygon.outer);
}

TEST(ConsensusRooms, noRunsAgreeOnNothing) {
  EXPECT_TRUE(consensusOf({}).rooms.shapes.empty());
  EXPECT_EQ(roomsAt(consensusOf({drawnAreas(threeRooms())}), kTop), 1u) << "one alone has a say";
  EXPECT_EQ(roomsAt(consensusOf({drawnAreas(threeRooms())}), kBelow), 1u);
}

}  // namespace
}  // namespace roomgraph::test
