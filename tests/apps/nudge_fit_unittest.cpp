#include <gtest/gtest.h>

#include "ViewState.h"
#include "sample_view.h"

namespace roomgraph {
namespace {

using test::viewWithMaps;

TEST(NudgeBy, turnsAboutTheMiddleOfTheMap) {
  const View view = viewWithMaps();
  ViewState state;
  nudgeBy({1, 0}, 0, view, state);
  EXPECT_EQ(shownPose(view, state, 0).x, 0) << "only while nudging";
  changeMode(Mode::nudge, view, state);
  const auto before = nudgeFit(view, state);
  ASSERT_TRUE(before);
  EXPECT_NEAR(before->overlap, 1, 1e-9);
  nudgeBy({0.2, 0.1}, 0, view, state);
  nudgeBy({0, 0}, 0.05, view, state);
  const Point middle = view.runs[0].map.middle();
  EXPECT_NEAR(distance(shownPose(view, state, 0)(middle), middle + Point{0.2, 0.1}), 0, 1e-9);
  EXPECT_EQ(shownPose(view, state, 1).x, 0);
  const auto moved = nudgeFit(view, state);
  EXPECT_LT(moved->overlap, 0.999);
  EXPECT_LT(moved->score, before->score);
  fitNudge(view, state);
  EXPECT_NEAR(shownPose(view, state, 0).x, 0, 0.02);
  EXPECT_NEAR(shownPose(view, state, 0).phi, 0, 0.005);
}

}  // namespace
}  // namespace roomgraph
