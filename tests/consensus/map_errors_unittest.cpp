#include "roomgraph/consensus/map_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "RandomNumbers.h"
#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

using test::roundTheBlock;
using test::Way;

/** The error of the first of some runs that lie at `truth`. */
MapError errorOf(const PoseGraph& graph, const std::vector<Way>& truth) {
  return mapErrors(graph, test::posesOf(truth))[RunId(0)];
}

/** The error of a run alone. */
MapError errorOf(const Way& drawn, const Way& truth) {
  return errorOf(test::drawnPoseGraph({drawn}), {truth});
}

TEST(MapErrors, aMapThatIsMovedAsAWholeHasNone) {
  const Way way = roundTheBlock();
  const Transform2D motion{4, -7, 2.5};
  const MapError error = errorOf(way, test::moved(way, motion));
  EXPECT_NEAR(error.error, 0, 1e-6);
  EXPECT_LT(distance(error.pose.shift(), motion.shift()), 1e-9);
  EXPECT_NEAR(wrappedAngle(error.pose.phi - motion.phi), 0, 1e-9);
  ASSERT_EQ(error.errors.size(), way.size());
  for (const double each : error.errors) EXPECT_NEAR(each, 0, 1e-6);
}

TEST(MapErrors, itIsTheDisplacementOfWhatWasDrawn) {
  const Way truth = roundTheBlock();
  for (const Way& drawn : {test::drifting(truth, 0.01), test::torn(truth, 20, 1.5, {3, 4}),
                           test::torn(truth, 50, M_PI, {})})
    EXPECT_NEAR(errorOf(drawn, truth).error, test::displacement(drawn, truth), 1e-9);
}

TEST(MapErrors, oneNodeThatIsOffHasTheErrorOfItsPoints) {
  const Way truth = roundTheBlock();
  Way drawn = truth;
  drawn[7] = drawn[7] * Transform2D{0.5, -0.2, 0.4};
  const MapError error = errorOf(drawn, truth);
  double squares = 0;
  for (const Point point : test::drawnPoints())
    squares += squaredNorm(error.pose(drawn[7](point)) - truth[7](point));
  EXPECT_NEAR(error.errors[7], std::sqrt(squares / double(test::drawnPoints().size())), 1e-9);
}

TEST(MapErrors, thoseOfTheNodesAddUp) {
  const Way truth = roundTheBlock();
  PoseGraph graph = test::drawnPoseGraph({test::drifting(truth, 0.01)});
  for (int i = 0; i < 20; ++i) graph.nodes[NodeId(40)].points.add({2, 2});  // it has drawn more
  const MapError error = errorOf(graph, {truth});
  double squares = 0, points = 0;
  for (const NodeId node : graph.nodes.ids()) {
    const double count = graph.nodes[node].points.count;
    squares += count * error.errors[node.index()] * error.errors[node.index()];
    points += count;
  }
  EXPECT_NEAR(error.error, std::sqrt(squares / points), 1e-9);
}

TEST(MapErrors, allRunsMayShareAScaleThatIsOffByMoreTheFartherTheyReach) {
  const Way truth = roundTheBlock();
  const auto scaled = [&](double by) {
    Way way = truth;
    for (Transform2D& pose : way) pose.x *= by, pose.y *= by;
    return way;
  };
  const MapError near = errorOf(truth, truth), far = errorOf(scaled(100), scaled(100));
  EXPECT_NEAR(near.reach, test::displacement(scaled(2), truth), 0.1);  // what they draw stays
  EXPECT_GT(near.high, 0.002 * near.reach);
  EXPECT_NEAR(far.high - near.high, 0.0025 * (far.reach - near.reach), 1e-6);
}

TEST(MapErrors, theFrameOfThePosesChangesNothing) {
  const Way truth = roundTheBlock(), torn = test::torn(truth, 20, 1, {2, 0});
  const MapError one = errorOf(torn, truth);
  const MapError other = errorOf(torn, test::moved(truth, {50, -80, 3}));
  EXPECT_NEAR(one.error, other.error, 1e-9);
  EXPECT_NEAR(one.low, other.low, 1e-9);
  EXPECT_NEAR(one.high, other.high, 1e-9);
  for (std::size_t k = 0; k < truth.size(); ++k) EXPECT_NEAR(one.errors[k], other.errors[k], 1e-9);
}

TEST(MapErrors, theIntervalHoldsTheErrorAndIsWiderForWhatIsUnseen) {
  const Way truth = roundTheBlock();
  const std::vector<Way> all{truth, truth, truth};
  const PoseGraph graph = test::matchedPoseGraph({test::drifting(truth, 0.01), truth, truth}, all);
  const auto first = [](const MatchGroup&, const PoseEdge&, std::size_t k) { return k < 30; };
  const MapError seen = errorOf(graph, all);
  const MapError half = errorOf(test::withMatches(graph, first), all);
  const MapError unseen = errorOf(test::withoutMatches(graph), all);
  EXPECT_EQ(seen.seen, 1);
  EXPECT_EQ(half.seen, 0.5);
  EXPECT_EQ(unseen.seen, 0);
  EXPECT_LT(seen.low, seen.error);
  EXPECT_GT(seen.high, seen.error);
  EXPECT_LT(half.low, seen.low);
  EXPECT_GT(half.high, seen.high);
  EXPECT_LT(unseen.low, half.low);
  EXPECT_GT(unseen.high, half.high);
  EXPECT_GE(unseen.low, 0);
}

TEST(MapErrors, whatARunHasOfItselfIsNotSeenByOthers) {
  const Way truth = roundTheBlock();
  PoseGraph graph = test::drawnPoseGraph({truth});
  graph.addGroup({RunId(0), RunId(0), {}}, {matchEdge(NodeId(3), NodeId(4), {}, 1)});
  const MapError error = errorOf(graph, {truth});
  EXPECT_EQ(error.seen, 0);
  EXPECT_FALSE(error.isSeen[3]);
}

TEST(MapErrors, theIntervalIsNarrowerForMoreRuns) {
  const Way truth = roundTheBlock(), drawn = test::drifting(truth, 0.01);
  double width = HUGE_VAL;
  for (const std::size_t runs : {2u, 3u, 6u}) {
    const std::vector<Way> poses(runs, truth);
    std::vector<Way> all = poses;
    all[0] = drawn;
    const PoseGraph graph = test::matchedPoseGraph(all, poses);
    const MapError error = errorOf(graph, poses);
    EXPECT_LT(error.high - error.low, width) << runs;
    width = error.high - error.low;
    EXPECT_EQ(mapError(graph, RunId(0), test::posesOf(poses), runs - 1).high, error.high);
  }
}

TEST(MapErrors, aRunThatHasSeenLittleIsLittleOfAWitness) {
  const Way truth = roundTheBlock(), drawn = test::drifting(truth, 0.01);
  const auto widthWith = [&](std::size_t most) {
    // Of the last run few have seen anything.
    const PoseGraph graph =
        test::withMatches(test::matchedPoseGraph({drawn, truth, truth}, {truth, truth, truth}),
                          [&](const MatchGroup& group, const PoseEdge&, std::size_t at) {
                            return !test::joins(group, 0, 2) || at < most;
                          });
    const MapError error = errorOf(graph, {truth, truth, truth});
    return error.high - error.low;
  };
  EXPECT_GT(widthWith(1), 1.05 * widthWith(1000));
}

TEST(MapErrors, aRunThatHasDrawnNothingHasNone) {
  PoseGraph blind = test::drawnPoseGraph({{}, {{}, {1, 0, 0}}});
  for (PoseNode& node : blind.nodes) node.points = {};
  const auto errors = mapErrors(blind, test::posesOf({{{}, {5, 0, 0}}}));
  ASSERT_EQ(errors.size(), 2u);
  for (const MapError& error : errors) {
    EXPECT_EQ(error.error, 0);
    EXPECT_EQ(error.seen, 0);
  }
  EXPECT_EQ(mapErrors({}, {}).size(), 0u);
}

/** A run whose nodes have drawn points of their own, anywhere. */
struct AnyRun {
  std::vector<std::vector<Point>> points;
  PoseGraph graph;
  Way poses;  // where they really lie

  explicit AnyRun(std::uint32_t seed) {
    test::RandomNumbers random(seed);
    graph.addRun(true);
    for (int k = 0; k < 12; ++k) {
      const Transform2D drawn = random.pose(10);
      poses.push_back(drawn * random.pose(1));
      points.emplace_back();
      PointSums sums;
      for (std::size_t i = random.below(6); i > 0; --i) {
        points.back().push_back(random.place(4));
        sums.add(points.back().back());
      }
      graph.addNode(drawn, sums, std::nullopt);
    }
  }

  const Transform2D& drawnAt(std::size_t k) const { return graph.nodes[NodeId(k)].pose; }

  /** Mean squared distance of all points after a motion, the slow way. */
  double meanSquare(const Transform2D& motion) const {
    double squares = 0, count = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      for (const Point p : points[k])
        squares += squaredNorm(motion(drawnAt(k)(p)) - poses[k](p)), ++count;
    return squares / count;
  }
};

TEST(MapErrors, noOtherMotionLeavesLessOver) {
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    const AnyRun any(seed);
    const MapError error = errorOf(any.graph, {any.poses});
    const double best = any.meanSquare(error.pose);
    EXPECT_NEAR(error.error, std::sqrt(best), 1e-9);
    for (const Transform2D& nudge :
         {Transform2D{0.01, 0, 0}, Transform2D{0, 0.01, 0}, Transform2D{0, 0, 0.01},
          Transform2D{-0.01, 0.02, -0.01}, Transform2D{1, 2, 3}})
      EXPECT_GT(any.meanSquare(nudge * error.pose), best) << seed;
  }
}

TEST(MapErrors, thoseOfNodesAreThoseOfTheirPoints) {
  const AnyRun any(7);
  const MapError error = errorOf(any.graph, {any.poses});
  for (std::size_t k = 0; k < any.points.size(); ++k) {
    if (any.points[k].empty()) continue;
    double squares = 0;
    for (const Point p : any.points[k])
      squares += squaredNorm(error.pose(any.drawnAt(k)(p)) - any.poses[k](p));
    EXPECT_NEAR(error.errors[k], std::sqrt(squares / double(any.points[k].size())), 1e-9) << k;
  }
}

TEST(MapErrors, areThoseOfTheRunsInAnyOrder) {
  const Way truth = roundTheBlock();
  const std::vector<Way> all{truth, truth, truth};
  std::vector<Way> drawn{test::drifting(truth, 0.01), truth, test::torn(truth, 20, 1, {})};
  // Of the torn run little was found, of the others more.
  const auto errorsOf = [&](std::size_t torn) {
    const PoseGraph graph = test::withMatches(
        test::matchedPoseGraph(drawn, all),
        [&](const MatchGroup& group, const PoseEdge&, std::size_t k) {
          const bool isOfTorn = group.to == RunId(torn) || group.from == RunId(torn);
          return k < (isOfTorn ? 5u : 20u);
        });
    return mapErrors(graph, test::posesOf(all));
  };
  const auto before = errorsOf(2);
  std::reverse(drawn.begin(), drawn.end());
  const auto after = errorsOf(0);
  for (std::size_t r = 0; r < 3; ++r) {
    EXPECT_EQ(after[RunId(2 - r)].error, before[RunId(r)].error);
    EXPECT_EQ(after[RunId(2 - r)].high, before[RunId(r)].high);
    EXPECT_EQ(after[RunId(2 - r)].isSeen, before[RunId(r)].isSeen);
  }
}

}  // namespace
}  // namespace roomgraph
