#include "roomgraph/consensus/pose_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_submaps.h"
#include "link_noise.h"
#include "start_poses.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

const std::vector<double> kNoSlack{1, 1, 1};

std::vector<double> allBelieved(const std::vector<RunMatches>& matches) {
  return std::vector<double>(matches.size(), 1.0);
}

TEST(PoseGraph, whatFitsStaysAsItIs) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  const std::vector<RunSubmaps> runs{drawnSubmaps(truth[0]), drawnSubmaps(truth[1])};
  const std::vector<RunMatches> matches = test::exactMatches(truth);
  for (const StartIs start : {StartIs::rough, StartIs::good}) {
    const auto found =
        solvePoseGraph({runs, matches, kNoSlack, allBelieved(matches), {}}, truth, start);
    EXPECT_LT(found.cost, 1e-9);
    EXPECT_LT(test::misplaced(found.poses, truth), 1e-6);
  }
}

TEST(PoseGraph, aRoughStartIsMended) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  std::vector<RunSubmaps> runs;
  for (const Way& way : truth) runs.push_back(drawnSubmaps(way));
  const std::vector<RunMatches> matches = test::exactMatches(truth);
  const SubmapPoses start{truth[0], test::drifting(truth[1], 0.01),
                          test::moved(truth[2], {0.5, -0.3, 0.1})};
  const auto found =
      solvePoseGraph({runs, matches, kNoSlack, allBelieved(matches), {}}, start, StartIs::rough);
  EXPECT_LT(test::misplaced(found.poses, truth), 0.02);
}

TEST(PoseGraph, theReferenceDoesNotMove) {
  const Way way = roundTheBlock(), bent = test::drifting(way, 0.01);
  const std::vector<RunSubmaps> runs{drawnSubmaps(way), drawnSubmaps(bent)};
  const std::vector<RunMatches> matches = test::exactMatches({way, way});
  const auto found = solvePoseGraph({runs, matches, kNoSlack, allBelieved(matches), 1},
                                    startPoses(runs, matches, 1), StartIs::rough);
  for (std::size_t k = 0; k < bent.size(); ++k) {
    EXPECT_EQ(found.poses[1][k].x, bent[k].x);
    EXPECT_EQ(found.poses[1][k].y, bent[k].y);
    EXPECT_NEAR(wrappedAngle(found.poses[1][k].phi - bent[k].phi), 0, 1e-12);
  }
  EXPECT_LT(test::displacement(found.poses[0], bent), 0.5 * test::displacement(way, bent));
}

TEST(PoseGraph, itsAxesStraightenALonelyRun) {
  const Way way = roundTheBlock();
  const Way bent = test::drifting(way, 0.004);
  std::vector<RunSubmaps> runs{drawnSubmaps(bent)};
  for (std::size_t k = 0; k < way.size(); ++k) runs[0].submaps[k].axes = ScanAxes{-way[k].phi, 1};
  const auto found = solvePoseGraph({runs, {}, {1}, {}, {}}, {bent}, StartIs::rough);
  EXPECT_LT(test::displacement(found.poses[0], way), 0.3 * test::displacement(bent, way));
  for (RunSubmaps& run : runs)
    for (Submap& submap : run.submaps) submap.axes.reset();
  const auto without = solvePoseGraph({runs, {}, {1}, {}, {}}, {bent}, StartIs::rough);
  EXPECT_LT(test::displacement(without.poses[0], bent), 1e-9);
}

TEST(MeanStrain, ofARunThatLiesAsItIsDrawnThereIsNone) {
  const Way way = roundTheBlock();
  EXPECT_NEAR(meanStrain(drawnSubmaps(way), test::moved(way, {3, 4, 1})), 0, 1e-12);
  EXPECT_EQ(meanStrain({}, {}), 0);
}

TEST(MeanStrain, ofADriftItIsThatOfEachStep) {
  Way straight;
  for (int k = 0; k < 40; ++k) straight.push_back({double(k), 0, 0});
  const double turn = 0.02, allowed = linkNoise({1, 0, turn}).turn;
  const double strain = meanStrain(drawnSubmaps(test::drifting(straight, turn)), straight);
  EXPECT_NEAR(strain, turn * turn / allowed / allowed / 3, 1e-9);
}

TEST(MeanStrain, aTearIsNotCounted) {
  const Way way = roundTheBlock();
  const RunSubmaps run = drawnSubmaps(test::torn(way, 30, M_PI / 2, {3, 4}));
  EXPECT_NEAR(meanStrain(run, way), 0, 1e-12);
}

}  // namespace
}  // namespace roomgraph
