#include "roomgraph/consensus/find_consensus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_pose_graph.h"
#include "roomgraph/consensus/map_errors.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** A sound run, one that drifts, and one that is torn, each in a frame of its own. */
struct ThreeMatched {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  std::vector<Way> drawn{test::moved(truth[0], {1, 2, 0.3}),
                         test::moved(test::drifting(truth[1], 0.004), {-5, 0, 2}),
                         test::moved(test::torn(truth[2], 30, M_PI / 2, {3, 4}), {0, 9, -1})};

  PoseGraph graph() const { return test::matchedPoseGraph(drawn, truth); }
};

TEST(FindConsensus, allRunsLieWhereTheyReallyAre) {
  ThreeMatched three;
  EXPECT_LT(test::misplaced(findConsensus(three.graph()).best, three.truth), 0.02);
  three.drawn[1] = three.truth[1];
  EXPECT_LT(test::misplaced(findConsensus(three.graph()).best, three.truth), 0.002)
      << "without a drift nothing pulls at what is sound";
}

TEST(FindConsensus, theErrorOfEachRunIsThatWhichItHas) {
  const ThreeMatched three;
  const PoseGraph graph = three.graph();
  const auto errors = mapErrors(graph, findConsensus(graph).best);
  EXPECT_LT(errors[RunId(0)].error, 0.02);
  for (const std::size_t r : {1u, 2u}) {
    const double really = test::displacement(three.drawn[r], three.truth[r]);
    ASSERT_GT(really, 0.3);
    EXPECT_NEAR(errors[RunId(r)].error, really, 0.05 * really) << r;
  }
}

TEST(FindConsensus, theErrorOfAWrongScaleIsToldInFull) {
  ThreeMatched three;
  three.drawn = three.truth;
  three.drawn[1] = test::scaled(three.truth[1], 1.04);
  const PoseGraph graph = three.graph();
  const ConsensusPoses found = findConsensus(graph);
  EXPECT_NEAR(found.stretches[RunId(1)], 1 / 1.04, 0.002);
  const auto errors = mapErrors(graph, found.best);
  EXPECT_LT(errors[RunId(0)].error, 0.02);
  EXPECT_LT(errors[RunId(2)].error, 0.02);
  const double really = test::displacement(three.drawn[1], three.truth[1]);
  EXPECT_NEAR(errors[RunId(1)].error, really, 0.05 * really);
}

TEST(FindConsensus, aThirdRunThatNothingWasFoundOfShowsNoScale) {
  ThreeMatched three;
  three.drawn = three.truth;
  three.drawn[1] = test::scaled(three.truth[1], 1.04);
  const PoseGraph graph =
      test::withMatches(three.graph(), [](const MatchGroup& group, const PoseEdge&, std::size_t) {
        return group.from != RunId(2) && group.to != RunId(2);
      });
  for (const double stretch : findConsensus(graph).stretches) EXPECT_EQ(stretch, 1);
}

TEST(FindConsensus, aRunThatIsTornFarIsNoLargerOne) {
  for (const double turn : {1.2, 2.2, 3.1}) {
    ThreeMatched three;
    three.drawn[1] = three.truth[1];
    three.drawn[2] = test::torn(three.truth[2], 30, turn, {});
    for (const double scale : findConsensus(three.graph()).stretches) EXPECT_NEAR(scale, 1, 0.002);
  }
}

TEST(FindConsensus, aRunMayBeTornByAnyTurn) {
  for (const double turn : {-0.3, 1.0, M_PI}) {
    ThreeMatched three;
    three.drawn[2] = test::torn(three.truth[2], 25, turn, {-4, 3});
    EXPECT_LT(test::misplaced(findConsensus(three.graph()).best, three.truth), 0.02) << turn;
  }
}

/** Seven runs, one of them torn and one that drifts: so many are first solved with few nodes. */
struct ManyRuns {
  std::vector<Way> truth, drawn;
  PoseGraph graph;

  ManyRuns() {
    for (const double offset : {0.0, 0.2, 0.4, 0.6, 0.8, 0.1, 0.5})
      truth.push_back(roundTheBlock(offset));
    drawn = truth;
    drawn[2] = test::moved(test::torn(truth[2], 29, 2, {-4, 3}), {0, 9, -1});
    drawn[4] = test::moved(test::drifting(truth[4], 0.004), {-5, 0, 2});
    graph = test::matchedPoseGraph(drawn, truth);
  }
};

TEST(FindConsensus, manyRunsLieWhereTheyReallyAre) {
  const ManyRuns many;
  EXPECT_LT(test::misplaced(findConsensus(many.graph).best, many.truth), 0.01);
}

TEST(FindConsensus, ofManyRunsEachHasTheScaleOfTheOthers) {
  ManyRuns many;
  many.drawn[5] = test::scaled(many.truth[5], 0.97);
  const PoseGraph graph = test::matchedPoseGraph(many.drawn, many.truth);
  const ConsensusPoses found = findConsensus(graph);
  EXPECT_LT(test::misplaced(found.best, many.truth), 0.01);
  EXPECT_NEAR(found.stretches[RunId(5)], 1 / 0.97, 0.003);
}

/** Whether the second run lies exactly as it was drawn. */
void expectToStay(const PoseGraph& graph, const NodePoses& poses, const std::vector<Way>& drawn) {
  const Way stays = test::wayOf(graph, poses, 1);
  for (std::size_t k = 0; k < stays.size(); ++k) {
    EXPECT_EQ(stays[k].shift(), drawn[1][k].shift());
    EXPECT_NEAR(wrappedAngle(stays[k].phi - drawn[1][k].phi), 0, 1e-12);
  }
}

TEST(FindConsensus, aReferenceOfManyRunsStaysExactlyAsItIs) {
  ManyRuns many;
  many.graph.reference = RunId(1);
  const NodePoses poses = findConsensus(many.graph).best;
  expectToStay(many.graph, poses, many.drawn);
  EXPECT_LT(test::misplaced(poses, many.truth), 0.01);
}

TEST(FindConsensus, aGroupThatWasFoundInAnotherWingIsGivenUpAsAWhole) {
  // Two sound runs that were found in each other one wing off, as in a building that repeats
  // itself. Torn between that and the third, they could bend to fit both.
  const ThreeMatched three;
  PoseGraph graph = test::matchedPoseGraph(three.truth, three.truth);
  const NodePoses truth = test::posesOf(three.truth);
  test::changeMatches(graph, [&](const MatchGroup& group, PoseEdge& edge, std::size_t) {
    if (test::joins(group, 0, 1))
      edge.measured = truth[edge.from].inverse() * Transform2D{0, 27, 0} * truth[edge.to];
  });
  const ConsensusPoses found = findConsensus(graph);
  for (const MapError& error : mapErrors(graph, found.best)) EXPECT_LT(error.error, 0.05);
  for (const MatchGroupId id : graph.groups.ids()) {
    if (test::joins(graph.groups[id], 0, 1))
      EXPECT_LT(found.trust.belief[id], 0.01);
    else
      EXPECT_EQ(found.trust.belief[id], 1);
  }
}

TEST(FindConsensus, tellsOtherAnswersThatAreAboutAsGood) {
  const PoseGraph graph = ThreeMatched().graph();
  const ConsensusPoses found = findConsensus(graph);
  EXPECT_EQ(found.others.size(), 3u) << "all starts come to the same";
  for (const NodePoses& other : found.others)
    EXPECT_LT(mapErrors(graph, other)[RunId(0)].error, 0.05);
}

TEST(FindConsensus, aWrongMatchAmongManyMovesNothing) {
  const ThreeMatched three;
  const NodePoses found = findConsensus(three.graph()).best;
  const Way before(found.begin(), found.end());
  for (const Transform2D& wrong :
       {Transform2D{3, -2, M_PI / 2}, Transform2D{0.5, 0, 0}, Transform2D{0, 0, M_PI}}) {
    PoseGraph graph = three.graph();
    test::changeMatches(graph, [&](const MatchGroup&, PoseEdge& edge, std::size_t place) {
      if (place == 20) edge.measured = wrong * edge.measured;
    });
    EXPECT_LT(test::misplaced(findConsensus(graph).best, {before}), 0.01);
  }
}

TEST(FindConsensus, theOrderOfTheRunsChangesTheFrameAtMost) {
  const ThreeMatched three;
  const PoseGraph first = three.graph();
  const NodePoses before = findConsensus(first).best;
  std::vector<std::size_t> order{0, 1, 2};
  while (std::next_permutation(order.begin(), order.end())) {
    ThreeMatched other;
    std::vector<Way> expected;
    for (std::size_t k = 0; k < 3; ++k) {
      other.drawn[k] = three.drawn[order[k]], other.truth[k] = three.truth[order[k]];
      expected.push_back(test::wayOf(first, before, order[k]));
    }
    EXPECT_LT(test::misplaced(findConsensus(other.graph()).best, expected), 0.005)
        << order[0] << order[1] << order[2];
  }
}

TEST(FindConsensus, aReferenceStaysExactlyAsItIs) {
  const ThreeMatched three;
  PoseGraph graph = three.graph();
  graph.reference = RunId(1);
  const NodePoses poses = findConsensus(graph).best;
  expectToStay(graph, poses, three.drawn);
  EXPECT_LT(test::displacement(test::wayOf(graph, poses, 0), test::wayOf(graph, poses, 1)), 2.0)
      << "the others follow it";
}

TEST(FindConsensus, aRunThatNothingWasFoundOfKeepsItsPoses) {
  ThreeMatched three;
  three.drawn.push_back(test::moved(test::torn(three.truth[0], 10, 1, {2, 2}), {30, 0, 1}));
  three.truth.push_back(test::moved(roundTheBlock(), {500, 0, 0}));
  const PoseGraph graph = three.graph();
  const NodePoses poses = findConsensus(graph).best;
  EXPECT_LT(test::misplaced(test::wayOf(graph, poses, 3), three.drawn[3]), 1e-6);
  Way others;
  for (const std::size_t run : {0u, 1u, 2u})
    for (const Transform2D& pose : test::wayOf(graph, poses, run)) others.push_back(pose);
  three.truth.pop_back();
  EXPECT_LT(test::misplaced(NodePoses(others), three.truth), 0.02);
}

TEST(FindConsensus, runsThatShareTheirScansDoNotOutvoteAnother) {
  const Way truth = roundTheBlock(), bent = test::drifting(truth, 0.004);
  PoseGraph graph = test::matchedPoseGraph({truth, bent, bent}, {truth, truth, truth});
  test::changeMatches(graph, [](const MatchGroup& group, PoseEdge& edge, std::size_t) {
    edge.isSameScan = test::joins(group, 1, 2);  // they are of one log
  });
  const auto errors = mapErrors(graph, findConsensus(graph).best);
  EXPECT_LT(errors[RunId(0)].error, 2 * errors[RunId(1)].error);
}

TEST(FindConsensus, oneRunIsEnough) {
  // It comes by twice, and drifts.
  const Way once = roundTheBlock();
  Way twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  const Way bent = test::drifting(twice, 0.002);
  PoseGraph graph = test::drawnPoseGraph({bent});
  std::vector<PoseEdge> matches;
  for (std::size_t k = 0; k < once.size(); ++k)
    matches.push_back(matchEdge(NodeId(k), NodeId(once.size() + k), {}, 1));
  graph.addGroup({RunId(0), RunId(0), {}}, matches);
  const NodePoses poses = findConsensus(graph).best;
  const auto gapOf = [&](auto poseAt) {
    return distance(poseAt(5).shift(), poseAt(once.size() + 5).shift());
  };
  EXPECT_GT(gapOf([&](std::size_t k) { return bent[k]; }), 0.5);
  EXPECT_LT(gapOf([&](std::size_t k) { return poses[NodeId(k)]; }), 0.2);
}

TEST(FindConsensus, anyJobOrderGivesTheSameNumbers) {
  const PoseGraph graph = ThreeMatched().graph();
  const ForEach backwards = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count > 0) job(--count);
  };
  const NodePoses l = findConsensus(graph).best, r = findConsensus(graph, backwards).best;
  for (const NodeId node : l.ids()) {
    EXPECT_EQ(l[node].shift(), r[node].shift());
    EXPECT_EQ(l[node].phi, r[node].phi);
  }
}

TEST(FindConsensus, ofNoRunsThereIsNone) {
  EXPECT_EQ(findConsensus({}).best.size(), 0u);
  EXPECT_EQ(findConsensus(test::drawnPoseGraph({{}, {}})).best.size(), 0u) << "runs without nodes";
}

}  // namespace
}  // namespace roomgraph
