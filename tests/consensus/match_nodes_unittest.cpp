#include "roomgraph/consensus/match_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "sample_runs.h"

namespace roomgraph {
namespace {

const Transform2D kThere{12, -7, 0.6};

/** A building, drawn by runs that lie in frames of their own. */
struct Building {
  Grid grid = test::drawnBuilding(4, {});
  std::vector<Keyframe> frames = test::drawnDrive(grid);

  roomgraph::Run run(const Transform2D& pose, bool hasScans) const {
    roomgraph::Run run;
    run.map = wallMap(test::drawnBuilding(4, pose));
    if (hasScans) run.scans = scanWalls(test::moved(frames, pose));
    return run;
  }
};

const Building& building() {
  static const Building the;
  return the;
}

/** What of one run was found in another, and the graph of both. */
struct Found {
  PoseGraph graph;
  std::vector<FoundGroup> groups;

  Found(const roomgraph::Run& run, const roomgraph::Run& other, const Transform2D& pose) {
    const RunId from = addRunNodes(other, graph), to = addRunNodes(run, graph);
    const DrawnBy drawn = drawnBy(other, graph.runs[from].nodes, other.map);
    groups = matchNodes(graph, to, run, {from, other.map, drawn},
                        followWalls(run.map, other.map, {pose}), {pose});
  }

  std::vector<PoseEdge> matches() const {
    std::vector<PoseEdge> all;
    for (const FoundGroup& group : groups)
      all.insert(all.end(), group.matches.begin(), group.matches.end());
    return all;
  }
  /** The place of the node that a match found in its run. */
  std::size_t placeOf(const PoseEdge& match) const {
    return graph.runs[RunId(1)].nodes.placeOf(match.to);
  }
};

void expectTrue(const Found& found) {
  std::set<NodeId> nodes;
  for (const PoseEdge& match : found.matches()) {
    const Transform2D there = found.graph.nodes[match.from].pose;
    const Transform2D truth = there.inverse() * kThere * found.graph.nodes[match.to].pose;
    EXPECT_LT(distance(match.measured.shift(), truth.shift()), 0.15) << match.to.index();
    EXPECT_NEAR(wrappedAngle(match.measured.phi - truth.phi), 0, 0.03) << match.to.index();
    EXPECT_LT(norm(match.measured.shift()), 10) << "they have drawn the same walls";
    EXPECT_GE(match.share, 0.45);
    EXPECT_LE(match.share, 1);
    EXPECT_FALSE(match.isSameScan);
    EXPECT_EQ(found.graph.runOf(match.from), RunId(0));
    EXPECT_EQ(found.graph.runOf(match.to), RunId(1));
    nodes.insert(match.to);
  }
  EXPECT_GT(double(nodes.size()), 0.9 * double(found.graph.runs[RunId(1)].nodes.size()));
}

TEST(MatchNodes, eachScanLiesInTheOtherRunWhereItWasTaken) {
  expectTrue({building().run({}, true), building().run(kThere, true), kThere});
}

TEST(MatchNodes, eachPatchLiesInTheOtherRunWhereItWasDrawn) {
  expectTrue({building().run({}, false), building().run(kThere, false), kThere});
}

TEST(MatchNodes, scansAndPatchesFindEachOther) {
  expectTrue({building().run({}, true), building().run(kThere, false), kThere});
}

TEST(MatchNodes, aScanThatIsItsOwnIsMatchedWithItself) {
  const roomgraph::Run run = building().run({}, true);
  const auto matches = Found(run, run, {}).matches();
  for (const PoseEdge& match : matches) EXPECT_LT(norm(match.measured.shift()), 1.5);
  EXPECT_EQ(matches.size(), run.scans.size());
}

TEST(MatchNodes, inAnotherBuildingThereAreNone) {
  const roomgraph::Run run = building().run({}, true), flat = building().run({}, false);
  roomgraph::Run other;
  other.map = wallMap(test::squareHall({300, 0, 0}));
  EXPECT_TRUE(Found(run, other, {}).groups.empty());
  EXPECT_TRUE(Found(flat, other, {}).groups.empty());
  PoseGraph graph;
  const RunId id = addRunNodes(run, graph);
  const DrawnBy drawn = drawnBy(run, graph.runs[id].nodes, run.map);
  EXPECT_TRUE(matchNodes(graph, id, run, {id, run.map, drawn}, {}, {}).empty())
      << "where no wall was followed";
}

TEST(MatchNodes, aTornRunIsFoundInTwoGroups) {
  const roomgraph::Run sound = building().run({}, true);
  roomgraph::Run torn = sound;
  torn.scans = scanWalls(test::broken(building().frames, 18, 0.4, {1, 2}));
  const Found found(torn, sound, {});
  ASSERT_EQ(found.groups.size(), 2u);
  EXPECT_EQ(found.placeOf(found.groups[0].matches.front()), 0u);
  EXPECT_EQ(found.placeOf(found.groups[0].matches.back()), 17u);
  EXPECT_EQ(found.placeOf(found.groups[1].matches.front()), 18u);
  for (const FoundGroup& one : found.groups) {
    EXPECT_EQ(one.group.from, RunId(0));
    EXPECT_EQ(one.group.to, RunId(1));
  }
  EXPECT_EQ(Found(sound, sound, {}).groups.size(), 1u) << "a sound one is in one";
}

/** Scans that are named, with an end each. */
roomgraph::Run named(const std::vector<std::uint64_t>& ids) {
  roomgraph::Run run;
  for (const std::uint64_t id : ids) {
    run.scans.emplace_back();
    run.scans.back().scanId = id;
    run.scans.back().ends.add({1, 0});
  }
  return run;
}

/** The scans of two runs that both have: places in the first, and in the second. */
std::vector<std::pair<std::size_t, std::size_t>> common(const roomgraph::Run& a,
                                                        const roomgraph::Run& b) {
  PoseGraph graph;
  const RunId first = addRunNodes(a, graph), second = addRunNodes(b, graph);
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (const PoseEdge& match : sameScans(graph, first, a, second, b).matches) {
    EXPECT_TRUE(match.isSameScan);
    EXPECT_EQ(norm(match.measured.shift()), 0);
    EXPECT_EQ(match.measured.phi, 0);
    EXPECT_EQ(match.share, 1);
    places.emplace_back(graph.runs[first].nodes.placeOf(match.to),
                        graph.runs[second].nodes.placeOf(match.from));
  }
  return places;
}

TEST(SameScans, areThoseOfOneLog) {
  const auto same = common(named({11, 12, 13, 14}), named({14, 99, 12}));
  ASSERT_EQ(same.size(), 2u);
  EXPECT_EQ(same[0], std::pair(std::size_t{1}, std::size_t{2}));
  EXPECT_EQ(same[1], std::pair(std::size_t{3}, std::size_t{0}));
}

TEST(SameScans, ofOtherLogsThereAreNone) {
  EXPECT_TRUE(common(named({1, 2, 3}), named({4, 5})).empty());
  EXPECT_TRUE(common(named({}), named({4, 5})).empty());
}

TEST(SameScans, aScanThatMetNothingIsNone) {
  roomgraph::Run blind = named({1, 2});
  blind.scans[0].ends = {};
  EXPECT_EQ(common(blind, named({1, 2})).size(), 1u);
  EXPECT_EQ(common(named({1, 2}), blind).size(), 1u);
}

// The nodes of a run that is not the first of its graph.
constexpr std::size_t kFirstNode = 100;

DrawnBy drawnBy(const roomgraph::Run& run) {
  const std::size_t nodes = run.scans.empty() ? run.map.patches.size() : run.scans.size();
  return drawnBy(run, {kFirstNode, kFirstNode + nodes}, run.map);
}

/** By their places in the run. */
std::vector<std::size_t> drawersOf(const DrawnBy& drawn, std::size_t wall) {
  std::vector<std::size_t> places;
  for (std::uint32_t k = drawn.firsts[wall]; k < drawn.firsts[wall + 1]; ++k)
    places.push_back(drawn.nodes[k].index() - kFirstNode);
  return places;
}

TEST(DrawnBy, aScanHasDrawnTheWallsThatItMet) {
  const roomgraph::Run run = test::drivenRun();
  const DrawnBy result = drawnBy(run);
  ASSERT_EQ(result.firsts.size(), run.map.walls.size() + 1);
  ASSERT_EQ(result.firsts.back(), result.nodes.size());
  std::vector<double> drawn(run.scans.size());
  for (std::size_t wall = 0; wall < run.map.walls.size(); ++wall) {
    const auto by = drawersOf(result, wall);
    EXPECT_TRUE(std::is_sorted(by.begin(), by.end()));
    EXPECT_EQ(std::adjacent_find(by.begin(), by.end()), by.end());
    for (const std::size_t k : by) {
      ++drawn[k];
      const auto& met = run.scans[k].walls;
      EXPECT_TRUE(std::any_of(met.begin(), met.end(),
                              [&](const WallPoint& point) {
                                return distance(point.place, run.map.walls[wall].place) < 0.15;
                              }))
          << "wall " << wall << " by " << k;
    }
  }
  for (std::size_t k = 0; k < drawn.size(); ++k)
    EXPECT_GT(drawn[k], 0.3 * double(run.scans[k].walls.size())) << k;  // many meet one wall
}

TEST(DrawnBy, wallsThatTheScansDidNotMeetAreOfNone) {
  roomgraph::Run run = test::drivenRun();
  run.map = wallMap(test::drawnBuilding(4, {200, 0, 0}));
  EXPECT_TRUE(drawnBy(run).nodes.empty());
}

TEST(DrawnBy, withoutScansAWallIsOfItsPatch) {
  const roomgraph::Run run = test::scanlessRun();
  const DrawnBy result = drawnBy(run);
  for (std::size_t wall = 0; wall < run.map.walls.size(); ++wall) {
    const auto by = drawersOf(result, wall);
    ASSERT_EQ(by.size(), 1u);
    const auto& own = run.map.patches[by[0]].own;
    EXPECT_NE(std::find(own.begin(), own.end(), wall), own.end());
  }
}

TEST(DrawnBy, ofNothingIsNone) { EXPECT_TRUE(drawnBy(roomgraph::Run()).nodes.empty()); }

}  // namespace
}  // namespace roomgraph
