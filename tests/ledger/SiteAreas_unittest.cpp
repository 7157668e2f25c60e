#include "SiteAreas.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_areas.h"
#include "drawn_house.h"
#include "no_consensus.h"

namespace roomgraph::test {
namespace {

TEST(SiteAreas, frameHoldsAllOutlinesWithAMargin) {
  const Polygon a{{{1, 1}, {3, 1}, {3, 2}}, {}}, b{{{-4, 0}, {-3, 0}, {-3, 5}}, {}}, empty;
  const GridFrame frame = frameRound({&a, &empty, &b});
  for (const Point p : {Point{-4.4, -0.4}, {3.4, 5.4}})
    EXPECT_TRUE(frame.contains(frame.cellAt(p)));
  EXPECT_DOUBLE_EQ(frame.resolution, 0.1);
  EXPECT_LT(frame.width, 90);
}

TEST(SiteAreas, aLargeSiteHasLargerCells) {
  const Polygon campus{{{0, 0}, {2000, 0}, {2000, 1000}}, {}};
  const GridFrame frame = frameRound({&campus});
  EXPECT_GT(frame.resolution, 1);
  EXPECT_LT(frame.cellCount(), 1100000u);
  EXPECT_EQ(frameRound({}).cellCount(), 0u);
}

TEST(SiteAreas, haveShapesSamplesAndDoors) {
  const RunAreas run = drawnAreas(threeRooms(), threeDoors());
  ASSERT_EQ(run.shapes.size(), 4u);
  const SiteShape& room = run.shapes[1];
  EXPECT_NEAR(room.area, 5 * 2, 1e-9);
  EXPECT_NEAR(distance(room.middle, {8, 6.5}), 0, 1e-9);
  EXPECT_FALSE(room.isCorridor);
  EXPECT_TRUE(run.shapes[3].isCorridor);
  // One sample on each square of 0.2 m.
  EXPECT_NEAR(double(room.samples.size()), 10 / 0.04, 15);
  for (const Point p : room.samples) EXPECT_EQ(sideOf(room.polygon, p), Side::inside);
  EXPECT_EQ(run.doors[1].size(), 2u);
  EXPECT_TRUE(run.isOpenTo(1, 3));
  EXPECT_TRUE(run.isOpenTo(3, 1));
  EXPECT_FALSE(run.isOpenTo(0, 3));
}

TEST(SiteAreas, cellsAreLabelledByTheAreaTheyLieIn) {
  const RunAreas run = drawnAreas(threeRooms());
  const GridFrame frame = frameOf(threeRooms());
  const auto labelAt = [&](Point p) { return run.labels[frame.index(frame.cellAt(p))]; };
  EXPECT_EQ(labelAt({2, 6}), RunAreas::firstArea + 0);
  EXPECT_EQ(labelAt({8, 4}), RunAreas::firstArea + 3);
  EXPECT_EQ(labelAt({0.2, 0.2}), RunAreas::occupied);
}

/** Runs of the drawn house in frames of their own. */
struct Houses {
  std::vector<Transform2D> poses{{}, {4, -3, 1.2}, {-8, 1, -2.5}};
  std::vector<roomgraph::Run> runs;
  Site site;

  Houses() {
    for (const Transform2D& pose : poses) runs.push_back(runOf(house(), "run", pose));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      site.runs.push_back(&runs[i]);
      site.poses.push_back(poses[i].inverse());
    }
  }
  Houses(const Houses&) = delete;
};

TEST(SiteAreas, runsInFramesOfTheirOwnAreLaidOnEachOther) {
  const Houses houses;
  const SiteAreas areas = siteAreas(houses.site, noConsensus(houses.site), {1, 1, 1});
  ASSERT_EQ(areas.runs.size(), 3u);
  for (const RunAreas& run : areas.runs) {
    ASSERT_EQ(run.shapes.size(), house().rooms.size());
    for (std::size_t a = 0; a < run.shapes.size(); ++a) {
      EXPECT_LT(distance(run.shapes[a].middle, areas.runs[0].shapes[a].middle), 1e-6);
      EXPECT_NEAR(run.shapes[a].area, areas.runs[0].shapes[a].area, 1e-6);
      EXPECT_EQ(run.doors[a].size(), areas.runs[0].doors[a].size());
    }
    std::size_t same = 0, known = 0;
    for (std::size_t i = 0; i < run.labels.size(); ++i) {
      known += areas.runs[0].labels[i] != RunAreas::unknown;
      same +=
          areas.runs[0].labels[i] != RunAreas::unknown && run.labels[i] == areas.runs[0].labels[i];
    }
    EXPECT_GT(double(same), 0.93 * double(known)) << "but for cells at the walls";
  }
}

TEST(SiteAreas, weightsAreTheFourthRootsOfTrustAndNeverNothing) {
  const Houses houses;
  const auto weightsFor = [&](const Trust& trust) {
    std::vector<double> weights;
    for (const RunAreas& run : siteAreas(houses.site, noConsensus(houses.site), trust).runs)
      weights.push_back(run.weight);
    return weights;
  };
  const auto weights = weightsFor({1, 0.0625, 0});
  EXPECT_DOUBLE_EQ(weights[0], 1);
  EXPECT_DOUBLE_EQ(weights[1], 0.5);
  EXPECT_DOUBLE_EQ(weights[2], 0.1);
  EXPECT_EQ(weightsFor({0, 0, 0}), (std::vector<double>{1, 1, 1}));
}

TEST(SiteAreas, ofNoRunsThereAreNone) {
  const SiteAreas areas = siteAreas({}, {}, {});
  EXPECT_TRUE(areas.runs.empty());
  EXPECT_EQ(areas.frame.cellCount(), 0u);
}

TEST(SiteAreas, aRunWithoutAreasStillTellsWhatIsFree) {
  Houses houses;
  houses.runs[1].areas = {};
  const SiteAreas areas = siteAreas(houses.site, noConsensus(houses.site), {1, 1, 1});
  EXPECT_TRUE(areas.runs[1].shapes.empty());
  const auto free =
      std::count(areas.runs[1].labels.begin(), areas.runs[1].labels.end(), RunAreas::free);
  EXPECT_GT(free, 1000);
}

}  // namespace
}  // namespace roomgraph::test
