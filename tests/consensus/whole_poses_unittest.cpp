#include "whole_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

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
  three.graph.addGroup({RunId(1), RunId(1), {}, 0}, matches);
  EXPECT_LT(three.misplaced(), 1e-9);
}

}  // namespace
}  // namespace roomgraph
