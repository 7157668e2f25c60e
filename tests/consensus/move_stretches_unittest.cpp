#include "move_stretches.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "RandomNumbers.h"
#include "drawn_pose_graph.h"
#include "edge_cost.h"
#include "roomgraph/consensus/belief.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** Two sound runs round a block, and poses of which some key frames of the second lie elsewhere. */
struct TwoRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  PoseGraph graph = test::matchedPoseGraph(truth, truth);
  NodePoses poses = test::posesOf(truth);

  std::size_t last() const { return truth[1].size() - 1; }
  void misplace(std::size_t from, std::size_t to, const Transform2D& wrong = {27, 0, 0},
                std::size_t run = 1) {
    const IdRange<NodeId> nodes = graph.runs[RunId(run)].nodes;
    for (std::size_t k = from; k <= to; ++k) poses[nodes[k]] = wrong * poses[nodes[k]];
  }
  void move() { moveStretches(graph, ById<RunId, double>(graph.runs.size(), 1), poses); }
  double misplacedAfterMoving() {
    move();
    return test::misplaced(poses, truth);
  }
};

TEST(MoveStretches, bringsHomeWhatBothItsLinksHaveLetGo) {
  for (const std::size_t last : {20u, 21u, 27u}) {
    TwoRuns two;
    two.misplace(20, last);
    EXPECT_LT(two.misplacedAfterMoving(), 1e-6) << last;
  }
}

TEST(MoveStretches, bringsHomeSeveralAndBothEnds) {
  TwoRuns two;
  two.misplace(0, 4);
  two.misplace(20, 20);
  two.misplace(30, two.last());
  EXPECT_LT(two.misplacedAfterMoving(), 1e-6);
}

TEST(MoveStretches, bringsHomeAWholeRun) {
  TwoRuns two;
  two.misplace(0, two.last());
  EXPECT_LT(two.misplacedAfterMoving(), 1e-6);
}

TEST(MoveStretches, tearsARunWhereAGroupThatIsGivenUpWouldHaveIt) {
  TwoRuns two;
  // Drawn torn, and laid down as one: no link has given way, but what was found of its end lies
  // elsewhere.
  const Way torn = test::torn(two.truth[1], 25, 0, {3, 4});
  const PoseGraph whole = test::matchedPoseGraph({two.truth[0], torn}, two.truth);
  two.poses = test::posesOf({two.truth[0], torn});
  two.graph = test::withoutMatches(whole);
  two.graph.reference = RunId(0);
  const NodeId cut = whole.runs[RunId(1)].nodes[25];
  for (const MatchGroup& group : whole.groups)
    for (const bool isFront : {true, false}) {
      std::vector<PoseEdge> matches;
      for (const PoseEdgeId id : group.edges) {
        const PoseEdge& edge = whole.edges[id];
        if ((std::max(edge.from, edge.to) < cut) == isFront) matches.push_back(edge);
      }
      two.graph.addGroup(group, matches);
    }
  EXPECT_LT(two.misplacedAfterMoving(), 1e-6);
}

TEST(MoveStretches, leavesWhatLiesWhereItBelongs) {
  TwoRuns two;
  EXPECT_EQ(two.misplacedAfterMoving(), 0);
  // Torn in truth: all its matches say so, against one link.
  const Way torn = test::torn(two.truth[1], 25, 1.2, {3, 4});
  two.graph = test::matchedPoseGraph({two.truth[0], torn}, two.truth);
  EXPECT_EQ(two.misplacedAfterMoving(), 0);
}

/** How far all lies off where some key frames of a run were found in the next wing only, four times
 *  over, and its robot goes no farther than `reach` in one step [m]. */
double misplacedByTheNextWing(double reach) {
  TwoRuns two;
  const IdRange<NodeId> nodes = two.graph.runs[RunId(1)].nodes;
  const auto isOff = [&](NodeId node) { return !(node < nodes[20]) && !(nodes[27] < node); };
  two.graph =
      test::withMatches(two.graph, [&](const MatchGroup&, const PoseEdge& edge, std::size_t) {
        return !isOff(edge.from) && !isOff(edge.to);
      });
  for (const PoseEdgeId link : two.graph.runs[RunId(1)].links) two.graph.edges[link].reach = reach;
  two.misplace(20, 27, {14, 0, 0});
  std::vector<PoseEdge> matches;
  for (std::size_t k = 20; k <= 27; ++k) {
    const Transform2D& pose = two.poses[nodes[k]];
    const NodeId from = nearestNode(two.graph.runs[RunId(0)].nodes, two.poses, pose.shift());
    matches.push_back(matchEdge(from, nodes[k], two.poses[from].inverse() * pose, 1));
  }
  for (int group = 0; group < 4; ++group) two.graph.addGroup({RunId(0), RunId(1), {}}, matches);
  return two.misplacedAfterMoving();
}

TEST(MoveStretches, aRobotDoesNotLeapIntoAWingThatLooksAlike) {
  EXPECT_GT(misplacedByTheNextWing(15), 3) << "which it can reach";
  EXPECT_LT(misplacedByTheNextWing(5), 1e-6);
}

TEST(MoveStretches, theReferenceStays) {
  TwoRuns two;
  two.misplace(20, 22);
  two.graph = test::withoutMatches(two.graph);
  two.graph.reference = RunId(1);
  const Way before(two.poses.begin(), two.poses.end());
  two.move();
  EXPECT_EQ(test::misplaced(two.poses, {before}), 0);
}

/** What the whole graph costs, each group believed as far as its matches are inliers. */
double costOf(const TwoRuns& two) {
  constexpr double kLenient = 4;
  double cost = 0;
  for (const PoseEdge& edge : two.graph.edges)
    if (!edge.group) cost += linkTerm(edge, 1).cost(gapOf(edge, two.poses));
  for (const MatchGroup& group : two.graph.groups) {
    double sum = 0, inliers = 0;
    for (const PoseEdgeId id : group.edges) {
      const PoseEdge& edge = two.graph.edges[id];
      EdgeTerm term = matchTerm(edge, 1);
      term.noise = term.noise.times(kLenient);
      sum += term.cost(gapOf(edge, two.poses));
      inliers += isInlier(edge, gapOf(edge, two.poses), kInlier);
    }
    const double belief = beliefOf(inliers / double(group.edges.size()));
    cost += belief * sum + (1 - belief) * costOfGivingUp(group);
  }
  return cost;
}

TEST(MoveStretches, neverMakesTheGraphDearerWhateverLiesElsewhere) {
  test::RandomNumbers random(5);
  for (int i = 0; i < 30; ++i) {
    TwoRuns two;
    for (int stretch = 0; stretch < 3; ++stretch) {
      const std::size_t run = random.below(2), nodes = two.truth[run].size();
      const std::size_t first = random.below(nodes), last = first + random.below(nodes - first);
      two.misplace(first, last, random.pose(20), run);
    }
    const double before = costOf(two);
    two.move();
    const double after = costOf(two);
    EXPECT_LE(after, before + 1e-9) << i;
    const Way once(two.poses.begin(), two.poses.end());
    two.move();
    EXPECT_LE(costOf(two), after + 1e-9) << i;
    if (after < 1) {
      EXPECT_EQ(test::misplaced(two.poses, {once}), 0) << "what is home stays";
    }
  }
}

TEST(MoveStretches, leavesNoRunThatWouldBeCheaperWhereAMatchHasIt) {
  test::RandomNumbers random(6);
  for (int i = 0; i < 30; ++i) {
    TwoRuns two;
    for (const std::size_t run : {0u, 1u}) two.misplace(0, two.last() / 2, random.pose(20), run);
    two.misplace(0, two.last(), random.pose(20));
    two.move();
    const NodePoses moved = two.poses;
    const double cost = costOf(two);
    for (const PoseEdge& edge : two.graph.edges)
      for (const HalfEdge& half : halvesOf(edge)) {
        if (!edge.group) continue;
        const Transform2D motion = moved[half.other] * half.measured * moved[half.node].inverse();
        for (const NodeId node : two.graph.runs[two.graph.runOf(half.node)].nodes)
          two.poses[node] = motion * moved[node];
        EXPECT_GT(costOf(two), cost - 1 - 1e-9) << i;
        two.poses = moved;
      }
  }
}

TEST(MoveStretches, theFrameOfTheSiteChangesNothing) {
  TwoRuns here;
  here.misplace(10, 17);
  TwoRuns there = here;
  const Transform2D motion{-40, 13, 2.5};
  for (Transform2D& pose : there.poses) pose = motion * pose;
  here.move(), there.move();
  for (const NodeId node : here.poses.ids())
    EXPECT_LT(distance((motion * here.poses[node]).shift(), there.poses[node].shift()), 1e-9);
}

TEST(MoveStretches, patchesAreNotMoved) {
  TwoRuns two;
  two.misplace(20, 24);
  two.graph.runs[RunId(1)].hasScans = false;
  two.graph.reference = RunId(0);
  const Way before(two.poses.begin(), two.poses.end());
  two.move();
  EXPECT_EQ(test::misplaced(two.poses, {before}), 0);
}

TEST(MoveStretches, whatARunHasOfItselfHoldsItTogether) {
  Way way = roundTheBlock();
  const Way again = roundTheBlock();
  way.insert(way.end(), again.begin(), again.end());
  TwoRuns one;
  one.truth = {{}, way};
  one.graph = test::drawnPoseGraph({{}, way});
  one.poses = test::posesOf({way});
  for (const bool isBack : {false, true}) {
    std::vector<PoseEdge> matches;
    for (std::size_t k = 0; k < again.size(); ++k)
      matches.push_back(matchEdge(NodeId(isBack ? again.size() + k : k),
                                  NodeId(isBack ? k : again.size() + k), {}, 1));
    one.graph.addGroup({RunId(1), RunId(1), {}}, matches);
  }
  EXPECT_EQ(one.misplacedAfterMoving(), 0);
  one.misplace(70, 75);
  EXPECT_LT(one.misplacedAfterMoving(), 1e-6);
}

TEST(MoveStretches, ofNothingNothingMoves) {
  NodePoses none;
  moveStretches({}, {}, none);
  EXPECT_EQ(none.size(), 0u);
  moveStretches(test::drawnPoseGraph({{}, {}}), ById<RunId, double>(2, 1), none);
  EXPECT_EQ(none.size(), 0u);
}

}  // namespace
}  // namespace roomgraph
