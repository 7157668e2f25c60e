#include "match_areas.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_areas.h"

namespace roomgraph::test {
namespace {

/** The rooms of the drawing, with the neighbours that its doors make. */
RoomSet roomsOf(const RunAreas& run) {
  RoomSet rooms{run.shapes, std::vector<std::vector<std::size_t>>(run.shapes.size())};
  for (std::size_t a = 0; a < run.shapes.size(); ++a)
    for (std::size_t b = 0; b < run.shapes.size(); ++b)
      if (run.isOpenTo(a, b)) rooms.neighbours[a].push_back(b);
  return rooms;
}

/** What the three rooms and their corridor are in another drawing of the same size. */
std::vector<AreaMatch> matchesIn(const RunAreas& run) {
  const RoomSet rooms = roomsOf(drawnAreas(threeRooms(), threeDoors()));
  const GridFrame frame = frameOf(threeRooms());
  RoomFits fits;
  addFits(rooms.shapes, frame, run, fits);
  return matchAreas(rooms, fits, frame, run);
}

using Areas = std::vector<std::size_t>;

TEST(MatchAreas, eachRoomIsItself) {
  const auto matches = matchesIn(drawnAreas(threeRooms(), threeDoors()));
  ASSERT_EQ(matches.size(), 4u);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(matches[s].areas, Areas{s});
    EXPECT_EQ(matches[s].move.shift, (Point{0, 0}));
    EXPECT_DOUBLE_EQ(matches[s].overlap, 1);
    EXPECT_DOUBLE_EQ(matches[s].known, 1);
    EXPECT_FALSE(matches[s].isMerged);
  }
}

/** The drawing with every letter of `from` replaced. */
std::vector<std::string> replaced(std::vector<std::string> rows, const std::string& from, char by) {
  for (std::string& row : rows)
    for (char& letter : row)
      if (from.find(letter) != std::string::npos) letter = by;
  return rows;
}

TEST(MatchAreas, aRoomInTwoPiecesHasBoth) {
  std::vector<std::string> rows = threeRooms();
  for (std::size_t y = 11; y < 15; ++y) rows[y].replace(10, 3, "EEE");
  const auto matches = matchesIn(drawnAreas(rows));
  EXPECT_EQ(matches[2].areas, (Areas{2, 3})) << "the larger first";
  EXPECT_FALSE(matches[2].isMerged);
}

TEST(MatchAreas, twoRoomsInOneAreaAreMerged) {
  std::vector<std::string> rows = replaced(threeRooms(), "B", 'A');
  for (std::size_t y = 1; y < 6; ++y) rows[y] = "#AAAAAAAAAAAAAAAAAAAA#";
  const auto matches = matchesIn(drawnAreas(rows));
  EXPECT_EQ(matches[0].areas, Areas{0});
  EXPECT_EQ(matches[1].areas, Areas{0});
  EXPECT_TRUE(matches[0].isMerged);
  EXPECT_TRUE(matches[1].isMerged);
  EXPECT_FALSE(matches[2].isMerged);
}

TEST(MatchAreas, freeFloorIsThereThoughInNoArea) {
  const auto matches = matchesIn(drawnAreas(replaced(threeRooms(), "C", '.')));
  EXPECT_FALSE(matches[2].isMatched());
  EXPECT_DOUBLE_EQ(matches[2].free, 1);
  EXPECT_DOUBLE_EQ(matches[2].known, 1);
}

TEST(MatchAreas, freeFloorIsThereThoughInAreasOfOtherShapes) {
  // The room below and the corridor above it, drawn as upright strips.
  std::vector<std::string> rows = threeRooms();
  for (std::size_t y = 6; y < 15; ++y) rows[y] = "##########CCEEFFGGdddd";
  const auto matches = matchesIn(drawnAreas(rows));
  EXPECT_FALSE(matches[2].isMatched());
  EXPECT_GT(matches[2].free, 0.99);
}

TEST(MatchAreas, whatTheRunHasNotSeenIsUnknown) {
  const auto matches = matchesIn(drawnAreas(replaced(threeRooms(), "C", ' ')));
  EXPECT_FALSE(matches[2].isMatched());
  EXPECT_EQ(matches[2].known, 0);
}

TEST(MatchAreas, aRoomThatWasWalledUpIsGone) {
  const auto matches = matchesIn(drawnAreas(replaced(threeRooms(), "C", '#')));
  EXPECT_FALSE(matches[2].isMatched());
  EXPECT_DOUBLE_EQ(matches[2].known, 1);
  EXPECT_EQ(matches[2].free, 0);
}

TEST(MatchAreas, aRoomThatIsNotThereMovesAsItsNeighbours) {
  // All but the last row is drawn half a metre higher, and the room below the corridor is gone.
  std::vector<std::string> rows = replaced(threeRooms(), "C", '#');
  rows.erase(rows.begin());
  rows.push_back(rows.back());
  const auto matches = matchesIn(drawnAreas(rows));
  EXPECT_NEAR(matches[3].move.shift.y, 0.5, 0.11) << "the corridor";
  EXPECT_FALSE(matches[2].isMatched());
  EXPECT_NEAR(distance(matches[2].move.shift, matches[3].move.shift), 0, 1e-9);
}

TEST(MatchAreas, addFitsKeepsThoseThatAreThere) {
  const RunAreas run = drawnAreas(threeRooms());
  RoomFits fits(1);
  addFits(run.shapes, frameOf(threeRooms()), run, fits);
  ASSERT_EQ(fits.size(), 4u);
  EXPECT_TRUE(fits[0].empty());
  EXPECT_EQ(fits[1].count(1), 1u);
}

TEST(MatchAreas, theOrderOfTheAreasChangesNothing) {
  std::vector<std::string> rows = threeRooms();
  for (std::size_t y = 11; y < 15; ++y) rows[y].replace(10, 3, "EEE");  // a room in two pieces
  const RunAreas run = drawnAreas(rows, threeDoors());
  const auto before = matchesIn(run);
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  while (std::next_permutation(order.begin(), order.end())) {
    const auto after = matchesIn(reordered(run, order));
    for (std::size_t s = 0; s < before.size(); ++s) {
      ASSERT_EQ(after[s].areas.size(), before[s].areas.size()) << s;
      for (std::size_t k = 0; k < before[s].areas.size(); ++k)
        EXPECT_EQ(order[after[s].areas[k]], before[s].areas[k]) << s;
      EXPECT_EQ(after[s].overlap, before[s].overlap);
      EXPECT_EQ(after[s].move.shift, before[s].move.shift);
    }
  }
}

TEST(MatchAreas, aRunThatLiesABitOffIsMatchedAllTheSame) {
  for (const int columns : {1, 2}) {
    std::vector<std::string> rows = threeRooms();
    for (std::string& row : rows) {  // drawn further left
      row.erase(0, std::size_t(columns));
      row += std::string(std::size_t(columns), '#');
    }
    const auto matches = matchesIn(drawnAreas(rows));
    for (std::size_t s = 0; s < 3; ++s) {
      ASSERT_TRUE(matches[s].isMatched()) << s;
      EXPECT_EQ(matches[s].areas[0], s);
      EXPECT_NEAR(matches[s].move.shift.x, -columns * kDrawnCell, 0.15) << s;
      EXPECT_NEAR(matches[s].move.shift.y, 0, 0.15) << s;
      EXPECT_GT(matches[s].overlap, 0.9);
    }
  }
}

TEST(MatchAreas, noAreaIsTwoRoomsUnlessTheyAreMerged) {
  for (const std::string& gone : {std::string("A"), std::string("B"), std::string("d")}) {
    const auto matches = matchesIn(drawnAreas(replaced(threeRooms(), gone, '#')));
    std::vector<int> uses(4);
    for (const AreaMatch& match : matches)
      for (const std::size_t area : match.areas) uses[area] += !match.isMerged;
    for (const int count : uses) EXPECT_LE(count, 1) << gone;
  }
}

TEST(MatchAreas, aRoomHalfSeenIsKnownByThatHalf) {
  std::vector<std::string> rows = threeRooms();
  for (std::size_t y = 11; y < 15; ++y) rows[y].replace(14, 4, "    ");  // half of C
  const auto matches = matchesIn(drawnAreas(rows));
  EXPECT_NEAR(matches[2].known, 0.5, 0.05);
  EXPECT_EQ(matches[2].areas, Areas{2});
  EXPECT_GT(matches[2].overlap, 0.9) << "what was not looked at is left out";
}

TEST(MatchAreas, ofARunWithoutAreasNoneMatches) {
  std::vector<std::string> rows = threeRooms();
  const auto matches = matchesIn(drawnAreas(replaced(rows, "ABCd", '.')));
  for (const AreaMatch& match : matches) {
    EXPECT_FALSE(match.isMatched());
    EXPECT_EQ(match.move.shift, (Point{0, 0})) << "there is nobody to follow";
    EXPECT_DOUBLE_EQ(match.free, 1);
  }
  const RunAreas run = drawnAreas(threeRooms());
  EXPECT_TRUE(matchAreas({}, {}, frameOf(threeRooms()), run).empty());
}

}  // namespace
}  // namespace roomgraph::test
