#include "start_poses.h"

#include <gtest/gtest.h>

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
  graph.addGroup({RunId(0), RunId(1), {}, 0}, matches);
  expectSame(startsFrom(graph, 0)[1], way);
}

TEST(StartPoses, whatARunHasOfItselfPlacesNothing) {
  PoseGraph graph = test::drawnPoseGraph({roundTheBlock(), roundTheBlock()});
  const IdRange<NodeId> nodes = graph.runs[RunId(1)].nodes;
  graph.addGroup({RunId(1), RunId(1), {}, 0}, {matchEdge(nodes[3], nodes[20], {}, 1)});
  for (const Way& poses : startsFrom(graph, 0)) expectSame(poses, roundTheBlock());
}

}  // namespace
}  // namespace roomgraph
