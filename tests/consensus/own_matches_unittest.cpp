#include "own_matches.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "confirm_runs.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/consensus/PoseGraph.h"
#include "roomgraph/consensus/belief.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

std::vector<FoundGroup> matchesOf(const std::vector<Keyframe>& frames) {
  const Run run = test::runOf(frames);
  PoseGraph graph;
  const RunId id = addRunNodes(run, graph);
  return ownMatches(graph, id, run, barelyHeldSteps(run));
}

TEST(OwnMatches, aSoundRunHasNone) {
  EXPECT_TRUE(matchesOf(test::driveOnce()).empty());
  EXPECT_TRUE(matchesOf({}).empty());
}

TEST(OwnMatches, behindATearTheScansAreFoundInTheOneBeforeIt) {
  const std::vector<Keyframe>& once = test::driveOnce();
  const auto groups = matchesOf(test::broken(once, 18, 0.8, {2, -1}));
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].group.from, groups[0].group.to);
  ASSERT_EQ(groups[0].matches.size(), 12u);
  for (std::size_t i = 0; i < groups[0].matches.size(); ++i) {
    const PoseEdge& match = groups[0].matches[i];
    EXPECT_EQ(match.from, NodeId(17));
    EXPECT_EQ(match.to, NodeId(18 + i));
    EXPECT_TRUE(
        areNear(match.measured, once[17].pose.inverse() * once[18 + i].pose, {}, kSameScanAnswer));
  }
}

TEST(OwnMatches, theVeryEndTellsToo) {
  const std::vector<Keyframe>& once = test::driveOnce();
  const auto groups = matchesOf(test::broken(once, once.size() - 2, 0.8, {}));
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].matches.size(), 2u);
}

TEST(OwnMatches, aStretchEndsAtTheNextBreak) {
  const auto torn = test::broken(test::driveOnce(), 12, 0.8, {1, 1});
  const auto groups = matchesOf(test::broken(torn, 17, -0.9, {0, 2}));
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].matches.size(), 5u);
}

TEST(OwnMatches, aScannerThatIsCoveredTearsNothing) {
  std::vector<Keyframe> frames = test::driveOnce();
  for (std::size_t k = 4; k < 13; ++k)
    for (Point& end : frames[k].ends) end = (0.4 / norm(end)) * end;
  EXPECT_TRUE(matchesOf(frames).empty());
}

TEST(StepsToUnconfirmed, areThoseAtTheEdgesOfWhatOthersFound) {
  const std::vector<Keyframe>& once = test::driveOnce();
  const roomgraph::Run run = test::runOf(once);
  Consensus consensus;
  const RunId a = addRunNodes(run, consensus.graph), b = addRunNodes(run, consensus.graph);
  consensus.poses = consensus.graph.ownPoses();
  const auto asked = [&] {
    std::vector<std::size_t> steps;
    const std::vector<bool> isAsked = stepsToUnconfirmed(
        consensus.graph.runs[a].nodes,
        confirmedNodes(consensus.graph, consensus.poses, consensus.trust.belief));
    for (std::size_t k = 0; k < isAsked.size(); ++k)
      if (isAsked[k]) steps.push_back(k);
    return steps;
  };
  EXPECT_TRUE(asked().empty());
  std::vector<PoseEdge> matches;
  for (std::size_t k = 0; k < 10; ++k)
    matches.push_back(
        matchEdge(consensus.graph.runs[a].nodes[k], consensus.graph.runs[b].nodes[k], {}, 1));
  consensus.graph.addGroup({a, b, {}}, matches);
  consensus.trust.belief = ById<MatchGroupId, double>(1, beliefOf(1));
  EXPECT_EQ(asked(), (std::vector<std::size_t>{9, 10, 11}));
}

constexpr std::size_t kStep = 18;

/** What a run holds against a consensus that has all of it from kStep on moved. */
std::vector<PoseEdgeId> heldOf(const std::vector<Keyframe>& frames, double turn, Point shift,
                               bool isReference = false) {
  const Run run = test::runOf(frames);
  Site site;
  site.runs = {&run};
  Consensus consensus;
  const RunId id = addRunNodes(run, consensus.graph);
  if (isReference) consensus.graph.reference = id;
  consensus.siteRuns.add(0);
  for (const Keyframe& frame : test::broken(frames, kStep, turn, shift))
    consensus.poses.add(frame.pose);
  return heldSteps(site, consensus, oneByOne);
}

bool has(const std::vector<PoseEdgeId>& links, std::size_t scan) {
  return std::count(links.begin(), links.end(), PoseEdgeId(scan - 1)) > 0;
}

TEST(HeldSteps, aSoundRunHoldsTheStepAtWhichItIsToBreak) {
  EXPECT_TRUE(has(heldOf(test::driveOnce(), 2.2, {4, -3}), kStep));
}

TEST(HeldSteps, norMayItBreakBesideThat) {
  const auto held = heldOf(test::driveOnce(), 2.2, {4, -3});
  EXPECT_TRUE(has(held, kStep - 1));
  EXPECT_TRUE(has(held, kStep + 1));
  EXPECT_GT(held.size(), test::driveOnce().size() / 2);
}

TEST(HeldSteps, itMayBreakWhereItsScansDisagree) {
  constexpr std::size_t kTorn = kStep + 6;
  const auto held = heldOf(test::broken(test::driveOnce(), kTorn, -0.8, {1, 2}), 2.2, {4, -3});
  EXPECT_TRUE(has(held, kStep));
  EXPECT_FALSE(has(held, kTorn));
}

TEST(HeldSteps, whatItsScansDoNotTellApartIsLeftToOthers) {
  EXPECT_TRUE(heldOf(test::driveOnce(), 0, {}).empty());
  EXPECT_TRUE(heldOf(test::driveOnce(), 0.01, {0.05, 0}).empty());
}

TEST(HeldSteps, aTornRunDoesNotHoldTheStepAtWhichItIsMended) {
  EXPECT_TRUE(heldOf(test::broken(test::driveOnce(), kStep, -2.2, {1, 2}), 2.2, {}).empty());
}

TEST(HeldSteps, theReferenceIsNotAsked) {
  EXPECT_TRUE(heldOf(test::driveOnce(), 2.2, {4, -3}, true).empty());
}

TEST(TornRuns, areThoseWithALinkThatHasGivenWay) {
  Consensus consensus;
  for (const double shift : {0.0, 0.1, 3.0}) {
    addRunNodes(test::runOf(test::driveOnce()), consensus.graph);
    for (const Keyframe& frame : test::broken(test::driveOnce(), kStep, 0, {shift, 0}))
      consensus.poses.add(frame.pose);
  }
  consensus.trust.slack = ById<RunId, double>(3, 1);
  EXPECT_EQ(tornRuns(consensus), 1u);
  EXPECT_EQ(tornRuns({}), 0u);
}

}  // namespace
}  // namespace roomgraph
