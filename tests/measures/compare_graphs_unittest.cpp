#include "compare_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "RandomNumbers.h"
#include "drawn_graph.h"
#include "hand_built.h"
#include "roomgraph/geometry/Transform2D.h"

namespace roomgraph {
namespace {

using test::drawnGraph;
using test::everywhere;
using test::moved;
using test::patchesOver;

GraphMatch matched(const TopologyGraph& a, const TopologyGraph& b) {
  const WallPatches patches = patchesOver({});
  const FollowedWalls followed = everywhere(patches, {});
  return matchGraphs({a, patches, followed}, {b, patches, followed});
}

/** A match of vertices and edges of equal numbers. */
GraphMatch byNumbers(const TopologyGraph& a, const TopologyGraph& b) {
  GraphMatch match;
  for (std::size_t i = 0; i < a.vertices().size(); ++i)
    match.vertices.push_back({VertexId(i), VertexId(i), 0});
  for (std::size_t e = 0; e < a.edges().size(); ++e)
    match.paths.push_back({a.edges()[e].source.index(),
                           a.edges()[e].target.index(),
                           {HalfEdgeId(2 * e)},
                           {HalfEdgeId(2 * e)},
                           a.edges()[e].path.length,
                           b.edges()[e].path.length});
  return match;
}

TEST(CompareGraphs, aGraphAgreesWithItself) {
  const TopologyGraph graph = drawnGraph();
  const GraphComparison same = compareGraphs(graph, graph, matched(graph, graph), {});
  EXPECT_DOUBLE_EQ(same.coverageOfA.value.value(), 1);
  EXPECT_DOUBLE_EQ(same.coverageOfB.value.value(), 1);
  EXPECT_EQ(same.globalAccuracy.value, 0);
  EXPECT_NEAR(same.relativeAccuracy.value.value(), 0, 1e-9);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(same.consistency[k].value, 0) << k;
  EXPECT_EQ(same.lengthError.value, 0);
  EXPECT_NEAR(same.frechet.value.value(), 0, 1e-9);
  EXPECT_EQ(same.nearestA.value, 0);
  EXPECT_EQ(same.globalAccuracy.support, double(graph.vertices().size()));
  EXPECT_EQ(same.lengthError.support, double(graph.edges().size()));
}

TEST(CompareGraphs, aShiftIsGlobalButNotRelative) {
  const TopologyGraph graph = drawnGraph();
  const GraphComparison shifted =
      compareGraphs(graph, graph, matched(graph, graph), {Transform2D{}, Transform2D{0.3, 0.4, 0}});
  EXPECT_NEAR(shifted.globalAccuracy.value.value(), 0.5, 1e-9);
  EXPECT_NEAR(shifted.relativeAccuracy.value.value(), 0, 1e-9);
  EXPECT_NEAR(shifted.nearestA.value.value(), 0.5, 1e-9);
  EXPECT_NEAR(shifted.nearestB.value.value(), 0.5, 1e-9);
  EXPECT_NEAR(shifted.consistency[0].value.value(), 0, 1e-9);
}

TEST(CompareGraphs, aScaleShowsInLengthsAndOverAllHops) {
  const TopologyGraph graph = drawnGraph(),
                      larger = test::mapped(graph, [](Point p) { return 1.1 * p; });
  const GraphComparison found = compareGraphs(graph, larger, byNumbers(graph, larger), {});
  EXPECT_NEAR(found.lengthError.value.value(), 0.1 / 1.1, 1e-9);
  // One hop is a straight way here: its ends are 1.1 times as far apart.
  EXPECT_NEAR(found.consistency[0].value.value(), 0.1 / 1.05, 1e-9);
  EXPECT_GT(found.consistency[1].value.value(), 0.04);
  EXPECT_GT(found.relativeAccuracy.value.value(), 0.3);
  EXPECT_GT(found.frechet.value.value(), 0.05);
}

TEST(CompareGraphs, hopsAreCountedOverMatchedPaths) {
  // Five vertices in a row, 1 m apart, the last of which b has 0.5 m farther away.
  const auto row = [](double more) {
    return test::straightWays({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4 + more, 0}},
                              {{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  };
  const TopologyGraph a = row(0), b = row(0.5);
  const GraphComparison found = compareGraphs(a, b, byNumbers(a, b), {});
  EXPECT_EQ(found.consistency[0].support, 4);
  EXPECT_EQ(found.consistency[1].support, 3);
  EXPECT_EQ(found.consistency[2].support, 1);
  EXPECT_EQ(found.consistency[3].support, 0);
  EXPECT_FALSE(found.consistency[3].value);
  EXPECT_EQ(found.consistency[0].value, 0) << "three of four";
  EXPECT_NEAR(found.consistency[2].value.value(), 0.5 / 4.25, 1e-9);
}

TEST(CompareGraphs, whatOneGraphLacksItDoesNotCover) {
  const TopologyGraph all = drawnGraph(), part = test::westOf(all, 10);
  const GraphComparison found = compareGraphs(part, all, matched(part, all), {});
  EXPECT_NEAR(found.coverageOfB.value.value(), 1, 1e-9);
  EXPECT_LT(found.coverageOfA.value.value(), 0.6);
  EXPECT_EQ(found.nearestA.value, 0) << "as published, it does not see what is missing";
  EXPECT_GT(found.nearestB.value.value(), 1);
}

TEST(CompareGraphs, emptyGraphsHaveNoFigures) {
  const GraphComparison none = compareGraphs({}, {}, {}, {});
  EXPECT_FALSE(none.coverageOfA.value);
  EXPECT_FALSE(none.globalAccuracy.value);
  EXPECT_FALSE(none.relativeAccuracy.value);
  EXPECT_FALSE(none.frechet.value);
  EXPECT_FALSE(none.nearestA.value);
}

/** Half a circle or all of it, with many or few corners. */
Polyline arc(double radius, double angle, int corners) {
  Polyline line;
  for (int k = 0; k <= corners; ++k) {
    const double phi = angle * k / corners;
    line.push_back({radius * std::cos(phi), radius * std::sin(phi)});
  }
  return line;
}

Polyline moved(Polyline line, const Transform2D& pose) {
  for (Point& p : line) p = pose(p);
  return line;
}

TEST(PathFrechet, aPathMovedAsAWholeIsTheSame) {
  const Transform2D pose{3, -2, 1};
  EXPECT_NEAR(pathFrechet(arc(3, 2, 200), moved(arc(3, 2, 200), pose)).value(), 0, 1e-9);
  const Polyline loop = arc(3, 2 * M_PI, 200);
  EXPECT_NEAR(pathFrechet(loop, moved(loop, pose)).value(), 0, 1e-9);
}

TEST(PathFrechet, aDetourCountsByHowFarItLeads) {
  const Polyline straight{{0, 0}, {4, 0}}, roof{{0, 0}, {2, 1}, {4, 0}};
  EXPECT_NEAR(pathFrechet(straight, roof).value(), 1, 0.1);
}

TEST(PathFrechet, aLongerPathSticksOutAtBothEnds) {
  EXPECT_NEAR(pathFrechet({{0, 0}, {4, 0}}, {{0, 0}, {5, 0}}).value(), 0.5, 1e-9);
}

TEST(PathFrechet, walkingThereAndBackIsNotStayingThere) {
  // Each place of the one is near one of the other, but they are not walked in one order.
  const Polyline once{{0, 0}, {6, 0}}, thrice{{0, 0}, {4, 0}, {2, 0}, {6, 0}};
  EXPECT_GT(pathFrechet(once, thrice).value(), 0.9);
}

TEST(PathFrechet, isTheSameFromBothSidesAndBackwards) {
  const Polyline a = arc(3, 2, 30);
  const Polyline b = moved({{0, 0}, {1, 2}, {3, 2.5}, {4, 1}}, {1, 1, 0.5});
  const double there = pathFrechet(a, b).value();
  EXPECT_GT(there, 0.1);
  EXPECT_NEAR(pathFrechet(b, a).value(), there, 1e-9);
  Polyline backA = a, backB = b;
  std::reverse(backA.begin(), backA.end()), std::reverse(backB.begin(), backB.end());
  EXPECT_NEAR(pathFrechet(backA, backB).value(), there, 1e-9);
}

TEST(PathFrechet, aPathWithoutLengthHasNone) {
  EXPECT_FALSE(pathFrechet({}, {{0, 0}, {1, 0}}));
  EXPECT_FALSE(pathFrechet({{0, 0}, {1, 0}}, {{2, 2}, {2, 2}}));
}

/** The Fréchet distance of two rows of places by its definition: the shortest leash with which both
 *  can be walked, by trying all walks. */
double leash(const std::vector<Point>& a, const std::vector<Point>& b, std::size_t i,
             std::size_t j) {
  const double here = distance(a[i], b[j]);
  if (i == 0 && j == 0) return here;
  double before = HUGE_VAL;
  if (i > 0) before = std::min(before, leash(a, b, i - 1, j));
  if (j > 0) before = std::min(before, leash(a, b, i, j - 1));
  if (i > 0 && j > 0) before = std::min(before, leash(a, b, i - 1, j - 1));
  return std::max(here, before);
}

TEST(PathFrechet, isTheShortestLeash) {
  // 2 m are eight steps; both run between the same ends, so that nothing moves.
  test::RandomNumbers random(1);
  for (int trial = 0; trial < 5; ++trial) {
    Polyline a{{0, 0}}, b{{0, 0}};
    for (int k = 1; k < 8; ++k) {  // heights that leave steps of equal length
      const double up = random.between(0.02, 0.1);
      a.push_back({0.25 * k, k % 2 ? up : 0}), b.push_back({0.25 * k, k % 2 ? -up : 0});
    }
    a.push_back({2, 0}), b.push_back({2, 0});
    EXPECT_NEAR(pathFrechet(a, b).value(), leash(a, b, 8, 8), 0.05);
  }
}

TEST(PathFrechet, cornersThatChangeNothingChangeNothing) {
  const Polyline few{{0, 0}, {3, 0}, {3, 4.1}}, other{{0, 0}, {3, 1}, {3, 4.1}};
  Polyline many;
  for (int k = 0; k < 30; ++k) many.push_back({0.1 * k, 0});
  for (int k = 0; k <= 41; ++k) many.push_back({3, 0.1 * k});
  EXPECT_NEAR(pathFrechet(few, other).value(), pathFrechet(many, other).value(), 1e-6);
}

TEST(PathFrechet, growsWithTheSizeOfThePaths) {
  const Polyline straight{{0, 0}, {4, 0}}, roof{{0, 0}, {2, 1}, {4, 0}};
  Polyline large = roof;
  for (Point& p : large) p = 2.0 * p;
  EXPECT_NEAR(pathFrechet({{0, 0}, {8, 0}}, large).value(), 2 * pathFrechet(straight, roof).value(),
              0.1);
}

TEST(PathFrechet, aMirroredPathIsAnotherOne) {
  Polyline bow = arc(3, 2, 30), mirrored = bow;
  for (Point& p : mirrored) p.y = -p.y;
  EXPECT_GT(pathFrechet(bow, mirrored).value(), 0.5);
}

}  // namespace
}  // namespace roomgraph
