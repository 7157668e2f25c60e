#include "roomgraph/consensus/pose_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_submaps.h"
#include "graph_terms.h"
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

/** Half the robust squared residual of all links and matches, term by term. */
double costOf(const PoseGraph& graph, const SubmapPoses& poses) {
  double cost = 0;
  for (std::size_t r = 0; r < graph.runs.size(); ++r)
    for (const SubmapLink& link : graph.runs[r].links)
      cost += linkTerm(graph.runs[r], link, graph.slack[r])
                  .cost(poses[r][link.from], poses[r][link.to]);
  for (std::size_t m = 0; m < graph.matches.size(); ++m) {
    const RunMatches& piece = graph.matches[m];
    for (const SubmapMatch& match : piece.matches)
      cost += matchTerm(match, graph.belief[m])
                  .cost(poses[piece.in][match.in], poses[piece.of][match.submap]);
  }
  return cost;
}

/** A sound run, and one that drifts. */
struct Drifting {
  Way truth = roundTheBlock(), bent = test::drifting(truth, 0.004);
  std::vector<RunSubmaps> runs{drawnSubmaps(truth), drawnSubmaps(bent)};
  std::vector<RunMatches> matches = test::exactMatches({truth, truth});

  PoseGraph graph() const { return {runs, matches, {1, 1}, allBelieved(matches), {}}; }
  SubmapPoses start() const { return {truth, bent}; }
};

TEST(PoseGraph, itsCostIsThatOfItsTerms) {
  const Drifting drift;
  for (const StartIs startIs : {StartIs::rough, StartIs::good}) {
    const auto found = solvePoseGraph(drift.graph(), drift.start(), startIs);
    ASSERT_GT(found.cost, 0.1);
    EXPECT_NEAR(found.cost, costOf(drift.graph(), found.poses), 1e-6 * found.cost);
  }
}

TEST(PoseGraph, noPoseCanMoveAloneAndMakeItCheaper) {
  const Drifting drift;
  const PoseGraph graph = drift.graph();
  const auto found = solvePoseGraph(graph, drift.start(), StartIs::rough);
  for (const std::size_t k : {5u, 20u, 41u})
    for (const Transform2D& nudge : {Transform2D{0.01, 0, 0}, Transform2D{0, -0.01, 0},
                                     Transform2D{0, 0, 0.003}, Transform2D{-0.01, 0.01, -0.003}}) {
      SubmapPoses poses = found.poses;
      poses[1][k] = poses[1][k] * nudge;
      EXPECT_GT(costOf(graph, poses), found.cost) << k;
    }
}

TEST(PoseGraph, theFrameOfTheStartIsThatOfTheSolution) {
  const Drifting drift;
  const auto here = solvePoseGraph(drift.graph(), drift.start(), StartIs::rough);
  const Transform2D motion{30, -7, 2};
  const SubmapPoses start{test::moved(drift.truth, motion), test::moved(drift.bent, motion)};
  const auto there = solvePoseGraph(drift.graph(), start, StartIs::rough);
  EXPECT_NEAR(there.cost, here.cost, 1e-3 * here.cost);
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t k = 0; k < drift.truth.size(); ++k)
      EXPECT_LT(distance((motion * here.poses[r][k]).shift(), there.poses[r][k].shift()), 0.002);
}

TEST(PoseGraph, aRunWithMoreSlackBendsMore) {
  const Drifting drift;
  const auto restOf = [&](double slack) {
    PoseGraph graph = drift.graph();
    graph.slack = {0.1, slack};
    return test::displacement(solvePoseGraph(graph, drift.start(), StartIs::rough).poses[1],
                              drift.truth);
  };
  EXPECT_LT(restOf(1), restOf(0.2));
  EXPECT_LT(restOf(0.2), test::displacement(drift.bent, drift.truth));
}

TEST(PoseGraph, whatIsNotBelievedHasNoSay) {
  const Drifting drift;
  const auto alone = solvePoseGraph(drift.graph(), drift.start(), StartIs::good);
  std::vector<RunMatches> matches = drift.matches;
  matches.push_back(matches.front());
  for (SubmapMatch& match : matches.back().matches) match.pose = Transform2D{3, 0, 1} * match.pose;
  const auto with =
      solvePoseGraph({drift.runs, matches, {1, 1}, {1, 1, 0}, {}}, drift.start(), StartIs::good);
  EXPECT_NEAR(with.cost, alone.cost, 1e-6);
  EXPECT_LT(test::misplaced(with.poses, alone.poses), 1e-6);
}

TEST(PoseGraph, runsThatNothingJoinsKeepTheirShape) {
  const Way way = roundTheBlock(), torn = test::torn(way, 20, 1, {2, 3});
  const std::vector<RunSubmaps> runs{drawnSubmaps(way), drawnSubmaps(torn), {}};
  const auto found = solvePoseGraph({runs, {}, kNoSlack, {}, {}}, {way, torn, {}}, StartIs::rough);
  EXPECT_NEAR(found.cost, 0, 1e-9);
  EXPECT_LT(test::misplaced({found.poses[1]}, {torn}), 1e-6);
  EXPECT_TRUE(found.poses[2].empty());
}

TEST(PoseGraph, axesMayLieByAQuarterTurn) {
  const Way way = roundTheBlock();
  std::vector<RunSubmaps> runs{drawnSubmaps(way)};
  for (std::size_t k = 0; k < way.size(); ++k)
    runs[0].submaps[k].axes = ScanAxes{-way[k].phi + double(k % 4) * M_PI / 2, 1};
  const auto found = solvePoseGraph({runs, {}, {1}, {}, {}}, {way}, StartIs::rough);
  EXPECT_LT(found.cost, 1e-9);
  EXPECT_LT(test::displacement(found.poses[0], way), 1e-6);
}

TEST(MeanStrain, ofTwiceTheDriftItIsFourTimesAsMuch) {
  Way straight;
  for (int k = 0; k < 40; ++k) straight.push_back({double(k), 0, 0});
  const RunSubmaps run = drawnSubmaps(straight);
  const double once = meanStrain(run, test::drifting(straight, 0.001));
  EXPECT_NEAR(meanStrain(run, test::drifting(straight, 0.002)), 4 * once, 1e-6);
  EXPECT_NEAR(meanStrain(run, test::drifting(straight, -0.001)), once, 1e-9);
}

}  // namespace
}  // namespace roomgraph
