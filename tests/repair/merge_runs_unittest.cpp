#include "roomgraph/repair/merge_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "repaired_site.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

MergedRun mergedRun(std::vector<Keyframe> scans, double day) {
  return {"day " + std::to_string(day), std::move(scans), 1e9 + 86400 * day};
}

/** A place beside the way along the corridor, which many scans look through. */
Point inCorridor() { return test::drive(0)[15].pose({0, 0.7}); }

/** The scans with a round box of half a metre around a place: beams that meet it end there. */
std::vector<Keyframe> withBox(std::vector<Keyframe> scans, Point middle) {
  constexpr double radius = 0.25;
  for (Keyframe& scan : scans)
    for (Point& end : scan.ends) {
      const Point eye = scan.pose.shift(), there = scan.pose(end) - eye;
      const double length = norm(there), along = dot(middle - eye, there) / length;
      const double beside = distance(eye + (along / length) * there, middle);
      if (along < 0 || along > length || beside > radius) continue;
      end = (along - std::sqrt(radius * radius - beside * beside)) / length * end;
    }
  return scans;
}

bool isWallNear(const MergedMap& merged, Point place) {
  const GridFrame& frame = merged.map.frame;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y) {
      const Cell cell = frame.cellAt(place + Point{0.05 * x, 0.05 * y});
      if (frame.contains(cell) && merged.map.grey[frame.index(cell)] < 100) return true;
    }
  return false;
}

MergedMap merged(const std::vector<MergedRun>& runs) { return mergeRuns(runs, {}, oneByOne); }

TEST(MergeRuns, whatStoodThereOnceGoes) {
  const auto empty = test::drive(1), box = withBox(test::drive(2), inCorridor());
  ASSERT_TRUE(isWallNear(merged({mergedRun(box, 0)}), inCorridor()));
  const MergedMap map = merged({mergedRun(box, 0), mergedRun(empty, 1), mergedRun(empty, 2)});
  EXPECT_FALSE(isWallNear(map, inCorridor()));
  for (const auto& scans : map.leftOut) EXPECT_TRUE(scans.empty());
}

TEST(MergeRuns, whatTheLatestTwoHaveStays) {
  const auto empty = test::drive(1), box = withBox(test::drive(2), inCorridor());
  const MergedRun first = mergedRun(empty, 0), second = mergedRun(empty, 1),
                  third = mergedRun(empty, 2), fourth = mergedRun(box, 3), last = mergedRun(box, 4);
  EXPECT_TRUE(isWallNear(merged({first, second, third, fourth, last}), inCorridor()));
  EXPECT_FALSE(isWallNear(merged({mergedRun(box, 0), mergedRun(box, 1), mergedRun(box, 2),
                                  mergedRun(empty, 3), mergedRun(empty, 4)}),
                          inCorridor()));
}

TEST(MergeRuns, scansInTheWrongPlaceAreLeftOut) {
  auto wrong = test::drive(3);
  for (std::size_t k = 0; k < 10; ++k) wrong[k].pose = Transform2D{3.1, 1.7, 0.8} * wrong[k].pose;
  const MergedMap map =
      merged({mergedRun(test::drive(1), 0), mergedRun(test::drive(2), 1), mergedRun(wrong, 2)});
  EXPECT_TRUE(map.leftOut[0].empty());
  EXPECT_TRUE(map.leftOut[1].empty());
  EXPECT_GE(map.leftOut[2].size(), 6u);
  EXPECT_LE(map.leftOut[2].size(), 10u);
}

TEST(MergeRuns, aScanThatHasSlidAlongACorridorIsLeftOutThoughMostOfItsWallsAgree) {
  auto slid = test::drive(3);
  slid[15].pose.x += 1;
  const MergedMap map =
      merged({mergedRun(test::drive(1), 0), mergedRun(test::drive(2), 1), mergedRun(slid, 2)});
  EXPECT_EQ(map.leftOut[2], std::vector<std::size_t>{15});
}

TEST(MergeRuns, aRunInWhichMuchWasMovedKeepsItsScans) {
  auto changed = test::drive(3);
  for (std::size_t k = 0; k < changed.size(); k += 2)
    changed = withBox(changed, test::drive(0)[k].pose({0, 0.7}));
  const MergedMap map =
      merged({mergedRun(test::drive(1), 0), mergedRun(test::drive(2), 0), mergedRun(changed, 0)});
  EXPECT_LT(map.leftOut[2].size(), 3u);
}

TEST(MergeRuns, aPieceGoesAsAWhole) {
  MergedRun run = mergedRun(test::drive(3), 2);
  for (const Keyframe& scan : run.scans) run.drawn.push_back(scan.pose);
  for (std::size_t k = 0; k < 10; ++k) run.scans[k].pose = Transform2D{1, 0, 0} * run.scans[k].pose;
  const auto others = {mergedRun(test::drive(1), 0), mergedRun(test::drive(2), 1)};
  const auto leftOut = [&] {
    std::vector<MergedRun> runs(others);
    runs.push_back(run);
    return merged(runs).leftOut[2].size();
  };
  EXPECT_EQ(leftOut(), 10u);
  run.drawn.clear();
  EXPECT_LT(leftOut(), 10u)
      << "where some agree along the corridor, and nothing holds them together";
}

TEST(MergeRuns, whatNobodyTellsOfGoesWithTheScansBesideIt) {
  auto wrong = test::drive(3);
  for (std::size_t k = 0; k < 10; ++k) {
    wrong[k].pose = Transform2D{3.1, 1.7, 0.8} * wrong[k].pose;
    if (k == 4) wrong[k].pose.x += 60;  // where no other run has been
  }
  const MergedMap map =
      merged({mergedRun(test::drive(1), 0), mergedRun(test::drive(2), 1), mergedRun(wrong, 2)});
  EXPECT_TRUE(std::count(map.leftOut[2].begin(), map.leftOut[2].end(), 4));
  auto alone = test::drive(3);
  alone[4].pose.x += 60;
  const MergedMap kept =
      merged({mergedRun(test::drive(1), 0), mergedRun(test::drive(2), 1), mergedRun(alone, 2)});
  EXPECT_TRUE(kept.leftOut[2].empty()) << "between scans that others bear out";
}

TEST(MergeRuns, scansOfTheLatestTwoStayThoughTheOlderKnowNothingOfWhatWasMoved) {
  // So much is new that the older runs contradict most of what the scans beside it show.
  const auto empty = test::drive(1);
  const Point eye = empty[15].pose.shift();
  auto changed = test::drive(2);
  for (double turn = 0; turn < 6.2; turn += 0.5)
    changed = withBox(changed, eye + Point{0.9 * std::cos(turn), 0.9 * std::sin(turn)});
  const auto older = [&](std::size_t day) { return mergedRun(test::drive(1), double(day)); };
  const auto leftOut = [&](double lastDay) {
    const MergedMap map =
        merged({older(0), older(1), older(2), mergedRun(changed, 3), mergedRun(changed, lastDay)});
    return map.leftOut[3].size() + map.leftOut[4].size();
  };
  EXPECT_EQ(leftOut(4), 0u);
  EXPECT_GT(leftOut(-1), 0u) << "of which one was made before all others";
}

TEST(MergeRuns, eachCellTellsItsRunsAndItsAge) {
  const auto scans = test::drive(1);
  const std::vector<Keyframe> half(scans.begin(), scans.begin() + 5);
  const MergedMap map = merged({mergedRun(scans, 0), mergedRun(half, 10)});
  const auto at = [&](Point place) { return map.map.frame.index(map.map.frame.cellAt(place)); };
  EXPECT_EQ(map.runs[at(scans[2].pose.shift())], 2);
  EXPECT_EQ(map.time[at(scans[2].pose.shift())], 0);
  EXPECT_GE(map.runs[at(scans.back().pose.shift())], 1);
  EXPECT_EQ(map.runs[0], 0);
  EXPECT_LT(map.time[0], 0);
}

TEST(MergeRuns, whatReachesTooFarIsRefused) {
  auto far = test::drive(1);
  far[0].pose.x = 1e6, far[1].pose.y = 1e6;
  EXPECT_THROW(merged({mergedRun(far, 0)}), DataError);
}

}  // namespace
}  // namespace roomgraph
