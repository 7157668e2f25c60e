#include "held_steps.h"

#include <gtest/gtest.h>

#include "roomgraph/consensus/add_run_nodes.h"
#include "sample_drives.h"

namespace roomgraph {
namespace {

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

TEST(HeldSteps, aSoundRunHoldsTheStepAtWhichItIsToBreak) {
  const auto held = heldOf(test::driveOnce(), 2.2, {4, -3});
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held.front(), PoseEdgeId(kStep - 1));
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

}  // namespace
}  // namespace roomgraph
