#include "start_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

constexpr double kAlike = 1e-9;

const Transform2D kStart{7, -3, 2}, kElsewhere{-1, 9, -1};

void expectSame(const Way& l, const Way& r) {
  ASSERT_EQ(l.size(), r.size());
  for (std::size_t k = 0; k < l.size(); ++k) {
    EXPECT_LT(distance(l[k].shift(), r[k].shift()), kAlike) << k;
    EXPECT_LT(std::abs(wrappedAngle(l[k].phi - r[k].phi)), kAlike) << k;
  }
}

/** The start poses by run. */
std::vector<Way> startsFrom(const PoseGraph& graph, std::size_t pivot) {
  const NodePoses poses = startPoses(graph, RunId(pivot));
  std::vector<Way> ways;
  for (const RunId run : graph.runs.ids()) ways.push_back(test::wayOf(graph, poses, run.index()));
  return ways;
}

/** A run, and the same in another frame. */
PoseGraph twoAlike() {
  const Way way = roundTheBlock();
  return test::matchedPoseGraph({way, test::moved(way, kStart)}, {way, way});
}

TEST(StartPoses, eachNodeLiesWhereItWasFoundInThePivot) {
  const Way way = roundTheBlock(), other = roundTheBlock(0.4);
  const Way torn = test::torn(test::moved(other, kStart), 30, 1, {4, 5});
  const auto starts = startsFrom(test::matchedPoseGraph({way, torn}, {way, other}), 0);
  expectSame(starts[0], way);
  expectSame(starts[1], other);
}

TEST(StartPoses, aMatchNamedTheOtherWayRoundSaysTheSame) {
  for (const std::size_t to : {0u, 1u})
    expectSame(startsFrom(test::withMatches(twoAlike(),
                                            [&](const MatchGroup& group, const PoseEdge&,
                                                std::size_t) { return group.to == RunId(to); }),
                          0)[1],
               roundTheBlock());
}

TEST(StartPoses, theFrameIsThatOfThePivot) {
  for (const Way& way : startsFrom(twoAlike(), 1))
    expectSame(way, test::moved(roundTheBlock(), kStart));
}

TEST(StartPoses, whatWasNotFoundGoesWithTheNearestThatWas) {
  const Way way = roundTheBlock(), drawn = test::torn(way, 30, 1, {4, 5});
  const PoseGraph graph = test::withMatches(
      test::matchedPoseGraph({way, drawn}, {way, way}),
      [](const MatchGroup&, const PoseEdge&, std::size_t k) { return k == 10 || k == 50; });
  const Way spread = startsFrom(graph, 0)[1];
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (k == 30) continue;  // as near to the one as to the other
    EXPECT_LT(distance(spread[k].shift(), way[k].shift()), kAlike) << k;
  }
}

TEST(StartPoses, aRunIsPlacedThroughAnother) {
  const Way way = roundTheBlock();
  const PoseGraph graph = test::withMatches(
      test::matchedPoseGraph({way, test::moved(way, kStart), test::moved(way, kElsewhere)},
                             {way, way, way}),
      [](const MatchGroup& group, const PoseEdge&, std::size_t) {
        return !test::joins(group, 0, 2);  // they never met
      });
  for (const Way& poses : startsFrom(graph, 0)) expectSame(poses, way);
}

TEST(StartPoses, aRunThatWasFoundNowhereKeepsItsPoses) {
  const Way way = roundTheBlock(), there = test::moved(way, kStart);
  const auto starts = startsFrom(test::drawnPoseGraph({way, there, {}}), 0);
  expectSame(starts[0], way);
  expectSame(starts[1], there);
  EXPECT_TRUE(starts[2].empty());
}

TEST(StartPoses, eachPivotBringsSoundRunsTogetherAlike) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  const std::vector<Way> drawn{truth[0], test::moved(truth[1], kStart),
                               test::moved(truth[2], kElsewhere)};
  const PoseGraph graph = test::matchedPoseGraph(drawn, truth);
  for (const std::size_t pivot : {0u, 1u, 2u}) {
    const NodePoses poses = startPoses(graph, RunId(pivot));
    EXPECT_LT(test::misplaced(poses, truth), kAlike);
    const Way own = test::wayOf(graph, poses, pivot);
    for (std::size_t k = 0; k < own.size(); ++k)
      EXPECT_EQ(own[k].shift(), drawn[pivot][k].shift()) << "in its frame";
  }
}

TEST(StartPoses, whatThePivotSaysGoesBeforeWhatOthersSay) {
  const Way way = roundTheBlock();
  PoseGraph graph = test::matchedPoseGraph({way, way, way}, {way, way, way});
  std::size_t misled = 0;
  test::changeMatches(graph, [&](const MatchGroup& group, PoseEdge& edge, std::size_t) {
    if (test::joins(group, 1, 2)) edge.measured.x += 5, ++misled;  // they say what is wrong
  });
  ASSERT_GT(misled, 0u);
  for (const Way& poses : startsFrom(graph, 0)) expectSame(poses, way);
}

TEST(StartPoses, ofTwoMatchesOfANodeTheFirstCounts) {
  const Way way = roundTheBlock();
  PoseGraph graph = test::matchedPoseGraph({way, way}, {way, way});
  const MatchGroup first = graph.groups[MatchGroupId(0)];
  std::vector<PoseEdge> wrong;
  for (const PoseEdgeId id : first.edges) {
    wrong.push_back(graph.edges[id]);
    wrong.back().measured.x += 5;
  }
  graph.addGroup(first, wrong);
  expectSame(startsFrom(graph, 0)[1], way);
}

TEST(StartPoses, aPartThatNoLinkJoinsGoesWithTheFirstThatWasFound) {
  const Way way = roundTheBlock(), there = test::moved(way, kStart);
  PoseGraph graph = test::drawnPoseGraph({way});
  graph.addRun(true);
  NodeId last;
  for (std::size_t k = 0; k < there.size(); ++k) {
    const NodeId node = graph.addNode(there[k], {}, {});
    if (last && k != 40) graph.addLink(last, node);
    last = node;
  }
  std::vector<PoseEdge> matches;
  for (std::size_t k = 0; k < 10; ++k)
    matches.push_back(matchEdge(NodeId(k), graph.runs[RunId(1)].nodes[k], {}, 1));
  graph.addGroup({RunId(0), RunId(1), {}}, matches);
  expectSame(startsFrom(graph, 0)[1], way);
}

TEST(StartPoses, whatARunHasOfItselfPlacesNothing) {
  PoseGraph graph = test::drawnPoseGraph({roundTheBlock(), roundTheBlock()});
  const IdRange<NodeId> nodes = graph.runs[RunId(1)].nodes;
  graph.addGroup({RunId(1), RunId(1), {}}, {matchEdge(nodes[3], nodes[20], {}, 1)});
  for (const Way& poses : startsFrom(graph, 0)) expectSame(poses, roundTheBlock());
}

using test::roundTheBlock;
using test::Way;

/** Three runs in frames of their own. */
struct ThreeRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  std::vector<Way> drawn{truth[0], test::moved(truth[1], {7, -3, 2}),
                         test::moved(truth[2], {-1, 9, -1})};
  PoseGraph graph = test::matchedPoseGraph(drawn, truth);

  double misplaced() const { return test::misplaced(wholePoses(graph), truth); }

  /** Some matches of groups say that the run lies elsewhere. */
  template <class Which>
  void mislead(const Which& which) {
    const NodePoses lies = test::posesOf(truth);
    test::changeMatches(graph, [&](const MatchGroup& group, PoseEdge& edge, std::size_t place) {
      if (which(group, place))
        edge.measured = lies[edge.from].inverse() * Transform2D{27, 5, M_PI} * lies[edge.to];
    });
  }
};

TEST(WholePoses, allRunsLieWhereTheirMatchesHaveThem) { EXPECT_LT(ThreeRuns().misplaced(), 1e-9); }

TEST(WholePoses, noRunIsTorn) {
  ThreeRuns three;
  three.drawn[2] = test::torn(three.truth[2], 40, 1, {5, 6});
  const PoseGraph graph = test::matchedPoseGraph(three.drawn, three.truth);
  const NodePoses poses = wholePoses(graph);
  for (const PoseEdgeId id : graph.runs[RunId(2)].links) {
    const PoseEdge& link = graph.edges[id];
    const Transform2D now = poses[link.from].inverse() * poses[link.to];
    EXPECT_LT(distance(link.measured.shift(), now.shift()), 1e-9);
  }
  EXPECT_LT(distance(test::wayOf(graph, poses, 2)[0].shift(), three.truth[2][0].shift()), 1e-9)
      << "the larger part lies where it belongs";
}

TEST(WholePoses, mostMatchesOfAllRunsDecide) {
  ThreeRuns three;
  // The groups of the first two in each other are more than half wrong: the third tells better.
  three.mislead([](const MatchGroup& group, std::size_t place) {
    return test::joins(group, 0, 1) && place >= 10;
  });
  EXPECT_LT(three.misplaced(), 1e-9);
}

TEST(WholePoses, theReferenceStays) {
  ThreeRuns three;
  three.graph.reference = RunId(1);
  const Way stays = test::wayOf(three.graph, wholePoses(three.graph), 1);
  for (std::size_t k = 0; k < stays.size(); ++k)
    EXPECT_LT(distance(stays[k].shift(), three.drawn[1][k].shift()), 1e-9);
  EXPECT_LT(three.misplaced(), 1e-9);
}

TEST(WholePoses, aRunThatWasFoundNowhereKeepsItsPoses) {
  const ThreeRuns three;
  const PoseGraph graph = test::drawnPoseGraph({three.drawn[0], three.drawn[1], {}});
  const Way stays = test::wayOf(graph, wholePoses(graph), 1);
  EXPECT_LT(distance(stays[5].shift(), three.drawn[1][5].shift()), 1e-9);
}

TEST(WholePoses, theOrderOfRunsChangesTheFrameAtMost) {
  const auto misleadOneOfTwo = [](ThreeRuns& three, std::size_t to, std::size_t from) {
    three.mislead([&](const MatchGroup& group, std::size_t place) {
      return group.to == RunId(to) && group.from == RunId(from) && place < 20;
    });
  };
  ThreeRuns forth, back;
  std::reverse(back.truth.begin(), back.truth.end());
  std::reverse(back.drawn.begin(), back.drawn.end());
  back.graph = test::matchedPoseGraph(back.drawn, back.truth);
  misleadOneOfTwo(forth, 1, 0), misleadOneOfTwo(back, 1, 2);
  const NodePoses l = wholePoses(forth.graph), r = wholePoses(back.graph);
  EXPECT_LT(test::misplaced(r, {test::wayOf(forth.graph, l, 2), test::wayOf(forth.graph, l, 1),
                                test::wayOf(forth.graph, l, 0)}),
            1e-9);
}

TEST(WholePoses, theFirstRunGivesTheFrame) {
  const ThreeRuns three;
  const Way stays = test::wayOf(three.graph, wholePoses(three.graph), 0);
  for (std::size_t k = 0; k < stays.size(); ++k)
    EXPECT_EQ(stays[k].shift(), three.drawn[0][k].shift());
}

TEST(WholePoses, aMatchCountsAsMuchAsOfItWasFound) {
  ThreeRuns three;
  three.drawn.resize(2), three.truth.resize(2);
  three.graph = test::matchedPoseGraph(three.drawn, three.truth);
  const MatchGroup group = three.graph.groups[MatchGroupId(1)];
  std::vector<PoseEdge> right;
  for (std::size_t k = 0; k < 20; ++k) right.push_back(three.graph.edges[group.edges[k]]);
  // Two groups contradict each other: the smaller one was found better.
  three.graph = test::withMatches(three.graph, [](const MatchGroup& one, const PoseEdge&,
                                                  std::size_t) { return one.to == RunId(1); });
  three.mislead([](const MatchGroup&, std::size_t) { return true; });
  three.graph.addGroup(group, right);
  const auto setShare = [&](double share) {
    test::changeMatches(three.graph, [&](const MatchGroup&, PoseEdge& edge, std::size_t) {
      if (edge.group == MatchGroupId(0)) edge.share = share;
    });
  };
  setShare(0.1);
  EXPECT_LT(three.misplaced(), 1e-9);
  setShare(1);
  EXPECT_GT(three.misplaced(), 5) << "there are more of the others";
}

TEST(WholePoses, aRunIsPlacedThroughAnother) {
  ThreeRuns three;
  three.graph =
      test::withMatches(three.graph, [](const MatchGroup& group, const PoseEdge&, std::size_t) {
        return !test::joins(group, 0, 2);  // they never met
      });
  EXPECT_LT(three.misplaced(), 1e-9);
}

TEST(WholePoses, whatARunHasOfItselfHasNoSay) {
  ThreeRuns three;
  const IdRange<NodeId> nodes = three.graph.runs[RunId(1)].nodes;
  std::vector<PoseEdge> matches;
  for (std::size_t k = 0; k + 20 < nodes.size(); ++k)
    matches.push_back(matchEdge(nodes[k], nodes[k + 20], {}, 1));
  three.graph.addGroup({RunId(1), RunId(1), {}}, matches);
  EXPECT_LT(three.misplaced(), 1e-9);
}

}  // namespace
}  // namespace roomgraph
