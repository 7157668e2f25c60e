#include "ViewState.h"

#include <gtest/gtest.h>

#include "sample_view.h"

namespace roomgraph {
namespace {

using test::sampleView;

TEST(ViewState, stepsStayWithinTheRun) {
  const View view = sampleView();
  ViewState state;
  const auto after = [&](bool isForward, std::size_t by) {
    stepFrames(isForward, by, view, state);
    return state.frame;
  };
  EXPECT_EQ(after(false, 1), 0u);
  EXPECT_EQ(after(true, 1), 1u);
  EXPECT_EQ(after(true, 10), 4u);
  EXPECT_EQ(after(false, 10), 0u);
}

TEST(ViewState, theNextRunHasItsOwnKeyFrames) {
  const View view = sampleView();
  ViewState state;
  state.run = 1, state.frame = 29;
  nextRun(view, state);
  EXPECT_EQ(state.run, 0u);
  EXPECT_EQ(state.frame, 4u);
}

TEST(ViewState, breaksComeOneAfterTheOtherAndRoundAgain) {
  const View view = sampleView();
  ViewState state;
  stepFault(true, view, state);
  EXPECT_EQ(state.fault, 0u);
  EXPECT_EQ(state.run, 1u);
  EXPECT_EQ(state.frame, 12u);
  stepFault(true, view, state);
  EXPECT_EQ(state.fault, 1u);
  EXPECT_EQ(state.run, 0u);
  stepFault(true, view, state);
  EXPECT_EQ(state.fault, 0u);
  stepFault(false, view, state);
  EXPECT_EQ(state.fault, 1u);
}

TEST(ViewState, modesEndEachOtherAndNeedASecondRun) {
  const View view = sampleView();
  ViewState state;
  changeMode(Mode::measure, view, state);
  state.corners = {{0, 0}, {3, 4}};
  EXPECT_EQ(state.mode, Mode::measure);
  changeMode(Mode::swipe, view, state);
  EXPECT_EQ(state.mode, Mode::swipe);
  EXPECT_TRUE(state.corners.empty());
  changeMode(Mode::swipe, view, state);
  EXPECT_EQ(state.mode, Mode::look);
  View alone = view;
  alone.comparison.runs.resize(1);
  changeMode(Mode::swipe, alone, state);
  EXPECT_EQ(state.mode, Mode::look) << "there is nothing to hold the run against";
  EXPECT_FALSE(isBusy(state));
}

TEST(ViewState, leavingEndsAllThatWasBegun) {
  const View view = sampleView();
  const auto leaves = [&](const auto& begin) {
    ViewState state;
    begin(state);
    const bool wasBusy = isBusy(state);
    leave(state);
    return wasBusy && !isBusy(state);
  };
  EXPECT_TRUE(leaves([&](ViewState& state) { play(view, state); }));
  EXPECT_TRUE(leaves([&](ViewState& state) { flicker(view, state); }));
  EXPECT_TRUE(leaves([&](ViewState& state) { stepFault(true, view, state); }));
  EXPECT_TRUE(leaves([](ViewState& state) { state.showsKeys = true; }));
  for (const Mode mode : {Mode::measure, Mode::nudge, Mode::swipe})
    EXPECT_TRUE(leaves([&](ViewState& state) { changeMode(mode, view, state); })) << int(mode);
}

TEST(ViewState, atABreakTheBestOtherRunIsShownFirst) {
  View view = sampleView();
  view.comparison.runs.resize(3);
  ViewState state;
  lookAtFault(0, view, state);  // of run 1
  nextOther(view, state);
  EXPECT_EQ(state.other, 0u);
  nextOther(view, state);
  EXPECT_EQ(state.other, 2u);
}

TEST(ViewState, theOtherRunIsNeverTheShownOne) {
  View view = sampleView();
  view.comparison.runs.resize(3);
  ViewState state;
  state.run = 1;
  EXPECT_EQ(otherRun(view, state), 0u);
  nextOther(view, state);
  EXPECT_EQ(otherRun(view, state), 2u);
  nextOther(view, state);
  EXPECT_EQ(otherRun(view, state), 0u);
  nextRun(view, state);
  nextRun(view, state);
  EXPECT_EQ(state.run, 0u);
  EXPECT_EQ(otherRun(view, state), 1u);
}

TEST(ViewState, stagesComeOneAfterTheOtherAndThenTheResult) {
  View view = sampleView();
  ViewState state;
  stepStage(true, view, state);
  EXPECT_FALSE(state.stage) << "runs have no stages here";
  view.stages.emplace();
  stepStage(true, view, state);
  EXPECT_EQ(state.stage, 0u);
  stepStage(false, view, state);
  EXPECT_FALSE(state.stage);
  stepStage(false, view, state);
  EXPECT_EQ(state.stage, 15u);
  stepStage(true, view, state);
  EXPECT_FALSE(state.stage);
}

TEST(PlayOn, goesToTheEndAndStops) {
  const View view = sampleView();
  ViewState state;
  EXPECT_FALSE(playOn(view, state));
  play(view, state);
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(playOn(view, state));
  EXPECT_EQ(state.frame, 4u);
  EXPECT_FALSE(playOn(view, state));
  play(view, state);
  EXPECT_EQ(state.frame, 0u) << "from the start again";
}

}  // namespace
}  // namespace roomgraph
