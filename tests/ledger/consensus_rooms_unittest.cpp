#include "consensus_rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "drawn_areas.h"

namespace roomgraph::test {
namespace {

using Rows = std::vector<std::string>;

ConsensusRooms consensusOf(const std::vector<RunAreas>& runs) {
  return consensusRooms({frameOf(threeRooms()), runs}, oneByOne);
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

TEST(ConsensusRooms, theOrderOfTheAreasDoesNotMatter) {
  const RunAreas a = drawnAreas(threeRooms(), threeDoors());
  const RunAreas b = drawnAreas(withASplitRoom(), {}, 0.9);
  const ConsensusRooms before = consensusOf({a, b});
  const ConsensusRooms after =
      consensusOf({reordered(a, {2, 0, 3, 1}), reordered(b, {4, 1, 0, 3, 2})});
  ASSERT_EQ(after.rooms.shapes.size(), before.rooms.shapes.size());
  std::multiset<std::pair<double, double>> l, r;
  for (const SiteShape& room : before.rooms.shapes) l.insert({room.middle.x, room.middle.y});
  for (const SiteShape& room : after.rooms.shapes) r.insert({room.middle.x, room.middle.y});
  EXPECT_EQ(l, r);
}

TEST(ConsensusRooms, aMirroredSiteHasTheMirroredRooms) {
  const Rows plain = threeRooms(), split = withASplitRoom(), more = withAnotherRoom();
  const ConsensusRooms here = consensusOf({drawnAreas(plain), drawnAreas(split), drawnAreas(more)});
  const ConsensusRooms there = consensusOf(
      {drawnAreas(mirrored(plain)), drawnAreas(mirrored(split)), drawnAreas(mirrored(more))});
  ASSERT_EQ(here.rooms.shapes.size(), there.rooms.shapes.size());
  for (const SiteShape& room : here.rooms.shapes)
    EXPECT_EQ(roomsAt(there, mirrored(room.middle, plain)), roomsAt(here, room.middle));
}

TEST(ConsensusRooms, onlyHowWeightsCompareCounts) {
  const auto roomsOf = [](double unit) {
    return consensusOf({drawnAreas(threeRooms(), {}, unit), drawnAreas(withASplitRoom(), {}, unit),
                        drawnAreas(withAnotherRoom(), {}, 0.4 * unit)})
        .rooms.shapes.size();
  };
  EXPECT_EQ(roomsOf(1), roomsOf(0.1));
  EXPECT_EQ(roomsOf(1), roomsOf(64));
}

TEST(ConsensusRooms, theHeavierRunDecidesHowARoomIsDrawn) {
  const RunAreas whole = drawnAreas(threeRooms(), {}, 1),
                 split = drawnAreas(withASplitRoom(), {}, 2);
  EXPECT_EQ(consensusOf({whole, split}).rooms.shapes.size(), 5u);
  const RunAreas heavy = drawnAreas(threeRooms(), {}, 2),
                 light = drawnAreas(withASplitRoom(), {}, 1);
  EXPECT_EQ(consensusOf({heavy, light}).rooms.shapes.size(), 4u);
}

TEST(ConsensusRooms, noPlaceIsInTwoRooms) {
  const RunAreas whole = drawnAreas(threeRooms()), split = drawnAreas(withASplitRoom()),
                 more = drawnAreas(withAnotherRoom());
  for (const std::vector<RunAreas>& runs :
       {std::vector<RunAreas>{whole, split}, {split, more}, {whole, split, more, split}}) {
    const ConsensusRooms consensus = consensusOf(runs);
    for (double x = 0.25; x < 11; x += 0.5)
      for (double y = 0.25; y < 8; y += 0.5) EXPECT_LE(roomsAt(consensus, {x, y}), 1u);
  }
}

TEST(ConsensusRooms, eachRunIsMatchedWithEachRoom) {
  const ConsensusRooms consensus = consensusOf(
      {drawnAreas(threeRooms()), drawnAreas(withASplitRoom()),
       drawnAreas({"######################", "######################", "######################",
                   "######################", "######################", "######################",
                   "######################", "######################", "######################",
                   "######################", "######################", "##########CCCCCCCC####",
                   "##########CCCCCCCC####", "##########CCCCCCCC####", "##########CCCCCCCC####",
                   "######################"})});
  for (const auto& inRun : consensus.matches)
    EXPECT_EQ(inRun.size(), consensus.rooms.shapes.size());
  std::size_t matched = 0;
  for (const AreaMatch& match : consensus.matches[2]) matched += match.isMatched();
  EXPECT_EQ(matched, 1u) << "it has but one of them";
}

}  // namespace
}  // namespace roomgraph::test
