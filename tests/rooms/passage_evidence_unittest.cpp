#include "passage_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "MapText.h"
#include "Pose.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/rooms/reason_names.h"

namespace roomgraph::test {
namespace {

constexpr double kCell = 0.2;

/** Free cells with a wall round them; then walls. */
std::vector<std::string> space(int width, int height) {
  std::vector<std::string> rows(std::size_t(height + 2),
                                "#" + std::string(std::size_t(width), '.') + "#");
  rows.front() = rows.back() = std::string(std::size_t(width + 2), '#');
  return rows;
}

void fill(std::vector<std::string>& rows, int left, int top, int width, int height,
          char sign = '#') {
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) rows[std::size_t(y)][std::size_t(x)] = sign;
}

/** The one passage of a map. */
PassageEvidence evidenceOf(const std::vector<std::string>& rows) {
  const std::vector<Passage> passages = extract(greyMap(drawn(rows, kCell)), {}).areas.passages;
  EXPECT_EQ(passages.size(), 1u);
  return passages.empty() ? PassageEvidence{-1, PassageReason::mouth} : passages[0].evidence;
}

/** Two rooms, with a door of so many cells in the wall between them. */
std::vector<std::string> twoRooms(int door, int below) {
  std::vector<std::string> rows = space(41, 20);
  fill(rows, 21, 1, 1, 20);
  fill(rows, 21, 21 - below - door, 1, door, '.');
  return rows;
}

std::string reason(const PassageEvidence& evidence) { return nameOf(evidence.reason); }

TEST(PassageEvidence, aDoorInAWallHasWallOnBothSides) {
  EXPECT_EQ(reason(evidenceOf(twoRooms(5, 8))), "wall_on_both_sides");
}

TEST(PassageEvidence, aDoorInAWallMayBeAsWideAsWhatLiesBehindIt) {
  // A closet of 1 m x 1.6 m.
  std::vector<std::string> rows = space(41, 20);
  fill(rows, 1, 12, 41, 9);
  fill(rows, 1, 13, 17, 8, '.');
  fill(rows, 25, 13, 17, 8, '.');
  fill(rows, 19, 12, 5, 9, '.');
  const PassageEvidence evidence = evidenceOf(rows);
  EXPECT_EQ(reason(evidence), "wall_on_both_sides");
  EXPECT_NEAR(evidence.confidence, 1 - 1 / 3.0, 1e-9) << "by its width alone";
}

/** An opening in row 20, from one column to another, in a space between two walls of one cell, at
 *  columns 10 and 40, with free space behind both. */
std::string reasonOfOpening(int left, int right) {
  std::vector<std::string> rows = space(50, 40);
  for (const int wall : {10, 40}) fill(rows, wall, 1, 1, 40);
  fill(rows, 10, 20, left - 9, 1);
  fill(rows, right, 20, 41 - right, 1);
  const Grid grid = gridOf(drawn(rows, kCell));
  const int row = grid.frame.height - 1 - 20;
  const Point from = grid.frame.center({left, row}), to = grid.frame.center({right, row});
  return reason(passageEvidence(grid, {0, 1, from, to, distance(from, to) / 2}, 3, {}));
}

TEST(PassageEvidence, aDoorInACornerHasWallOnOneSide) {
  EXPECT_EQ(reasonOfOpening(10, 16), "wall_on_one_side");
  EXPECT_EQ(reasonOfOpening(34, 40), "wall_on_one_side");
  EXPECT_EQ(reasonOfOpening(14, 20), "wall_on_both_sides");
}

TEST(PassageEvidence, betweenThingsThatStickOutIsANarrowing) {
  EXPECT_EQ(reasonOfOpening(10, 40), "mouth") << "too wide for a door";
  std::vector<std::string> rows = space(50, 40);
  fill(rows, 20, 20, 2, 4);
  fill(rows, 27, 18, 2, 4);
  const Grid grid = gridOf(drawn(rows, kCell));
  const Point from = grid.frame.center({21, 41 - 20}), to = grid.frame.center({27, 41 - 20});
  EXPECT_EQ(reason(passageEvidence(grid, {0, 1, from, to, distance(from, to) / 2}, 3, {})),
            "narrowing");
}

TEST(PassageEvidence, whereACorridorMeetsAHallIsAMouth) {
  std::vector<std::string> rows = space(120, 60);
  fill(rows, 71, 1, 50, 25);
  fill(rows, 71, 34, 50, 27);
  const PassageEvidence mouth = evidenceOf(rows);
  EXPECT_EQ(reason(mouth), "mouth");
  EXPECT_LT(mouth.confidence, evidenceOf(twoRooms(5, 8)).confidence);
}

TEST(PassageEvidence, theNarrowerADoorTheSurerItIs) {
  double last = 1;
  for (const int door : {5, 6, 8, 10}) {
    const double confidence = evidenceOf(twoRooms(door, 4)).confidence;
    EXPECT_LT(confidence, last) << door;
    EXPECT_GT(confidence, 0) << door;
    last = confidence;
  }
}

TEST(PassageEvidence, isTheMeanOfHowMuchNarrowerItIsThanBoth) {
  const Grid grid = gridOf(drawn(twoRooms(5, 8), kCell));
  SplitAtDoorsOptions options;
  options.maxWidth = 2, options.minRoomWidth = 0;
  // Free widths: 0.8 m in an area of 1.6 m, and of 2 m.
  const RegionBorder border{0, 1, {}, {1, 0}, 0.4 + kCell / 2};
  EXPECT_NEAR(passageEvidence(grid, border, 0.8 + kCell / 2, options).confidence,
              std::sqrt(0.5 * 0.6), 1e-12);
}

TEST(PassageEvidence, aGapThatIsNarrowerThanAnyRoomIsLessSure) {
  const Grid grid = gridOf(drawn(twoRooms(5, 8), kCell));
  SplitAtDoorsOptions options;
  const RegionBorder border{0, 1, {}, {1, 0}, 0.2 + kCell / 2};
  options.minRoomWidth = 0.4;
  const double whole = passageEvidence(grid, border, 3, options).confidence;
  options.minRoomWidth = 0.8;
  EXPECT_NEAR(passageEvidence(grid, border, 3, options).confidence, whole / 2, 1e-12);
  options.minRoomWidth = 0;
  EXPECT_EQ(passageEvidence(grid, border, 3, options).confidence, whole);
}

TEST(PassageEvidence, isNoDoorAtAllWhereItIsAsWideAsTheAreaOrTheWidestDoor) {
  const Grid grid = gridOf(drawn(twoRooms(5, 8), kCell));
  const RegionBorder border{0, 1, {}, {1, 0}, 0.5};
  EXPECT_EQ(passageEvidence(grid, border, 0.5, {}).confidence, 0);
  SplitAtDoorsOptions narrow;
  narrow.maxWidth = 0.8;
  EXPECT_EQ(passageEvidence(grid, border, 3, narrow).confidence, 0);
  narrow.maxWidth = 0;
  EXPECT_EQ(passageEvidence(grid, border, 3, narrow).confidence, 0);
  EXPECT_EQ(passageEvidence(grid, border, kCell / 2, {}).confidence, 0) << "an area of no width";
}

TEST(PassageEvidence, anEndThatIsNoWallHalvesIt) {
  const Grid grid = gridOf(drawn(twoRooms(5, 8), kCell));
  RegionBorder border{0, 1, {}, {1, 0}, 0.5};
  const double all = passageEvidence(grid, border, 3, {}).confidence;
  ASSERT_GT(all, 0);
  border.wallEnds = 1;
  EXPECT_EQ(passageEvidence(grid, border, 3, {}).confidence, all / 2);
  EXPECT_EQ(reason(passageEvidence(grid, border, 3, {})), "unseen_side");
  border.wallEnds = 0;
  EXPECT_EQ(passageEvidence(grid, border, 3, {}).confidence, 0);
}

TEST(PassageEvidence, isTheSameHoweverTheMapLies) {
  for (const std::string& name : mapNames()) {
    const MapText map = readMapText(name);
    const auto all = [&](const MapText& posed) {
      std::vector<std::pair<std::string, double>> sorted;
      const Stages stages = extract(greyMap(posed), optionsOf(posed));
      for (const Passage& passage : stages.areas.passages)
        sorted.push_back({reason(passage.evidence), passage.evidence.confidence});
      std::sort(sorted.begin(), sorted.end());
      return sorted;
    };
    const auto straight = all(map);
    for (const Pose& pose : symmetries()) {
      const auto turned = all(posed(map, pose));
      ASSERT_EQ(turned.size(), straight.size()) << name;
      for (std::size_t i = 0; i < turned.size(); ++i) {
        EXPECT_EQ(turned[i].first, straight[i].first) << name;
        EXPECT_NEAR(turned[i].second, straight[i].second, 1e-6) << name;
      }
    }
  }
}

}  // namespace
}  // namespace roomgraph::test
