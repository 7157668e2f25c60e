#include "ViewState.h"

#include <gtest/gtest.h>

#include "sample_view.h"

namespace roomgraph {
namespace {

using test::sampleView;

TEST(Fulfil, stepsStayWithinTheRun) {
  const View view = sampleView();
  ViewState state;
  const auto after = [&](Wish wish) {
    fulfil(wish, view, state);
    return state.frame;
  };
  EXPECT_EQ(after(Wish::previousFrame), 0u);
  EXPECT_EQ(after(Wish::nextFrame), 1u);
  EXPECT_EQ(after(Wish::tenOn), 4u);
  EXPECT_EQ(after(Wish::tenBack), 0u);
  EXPECT_EQ(after(Wish::lastFrame), 4u);
  EXPECT_EQ(after(Wish::firstFrame), 0u);
}

TEST(Fulfil, theNextRunHasItsOwnKeyFrames) {
  const View view = sampleView();
  ViewState state;
  state.run = 1, state.frame = 29;
  fulfil(Wish::nextRun, view, state);
  EXPECT_EQ(state.run, 0u);
  EXPECT_EQ(state.frame, 4u);
}

TEST(Fulfil, breaksComeOneAfterTheOtherAndRoundAgain) {
  const View view = sampleView();
  ViewState state;
  fulfil(Wish::nextFault, view, state);
  EXPECT_EQ(state.fault, 0u);
  EXPECT_EQ(state.run, 1u);
  EXPECT_EQ(state.frame, 12u);
  fulfil(Wish::nextFault, view, state);
  EXPECT_EQ(state.fault, 1u);
  EXPECT_EQ(state.run, 0u);
  fulfil(Wish::nextFault, view, state);
  EXPECT_EQ(state.fault, 0u);
  fulfil(Wish::previousFault, view, state);
  EXPECT_EQ(state.fault, 1u);
}

TEST(Fulfil, modesEndEachOtherAndNeedASecondRun) {
  const View view = sampleView();
  ViewState state;
  fulfil(Wish::measure, view, state);
  state.corners = {{0, 0}, {3, 4}};
  EXPECT_EQ(state.mode, Mode::measure);
  fulfil(Wish::swipe, view, state);
  EXPECT_EQ(state.mode, Mode::swipe);
  EXPECT_TRUE(state.corners.empty());
  fulfil(Wish::swipe, view, state);
  EXPECT_EQ(state.mode, Mode::look);
  View alone = view;
  alone.comparison.runs.resize(1);
  fulfil(Wish::swipe, alone, state);
  EXPECT_EQ(state.mode, Mode::look) << "there is nothing to hold the run against";
  EXPECT_FALSE(isBusy(state));
}

TEST(Fulfil, leavingEndsAllThatWasBegun) {
  const View view = sampleView();
  for (const Wish wish : {Wish::play, Wish::flicker, Wish::measure, Wish::nudge, Wish::swipe,
                          Wish::keys, Wish::nextFault}) {
    ViewState state;
    fulfil(wish, view, state);
    EXPECT_TRUE(isBusy(state)) << int(wish);
    fulfil(Wish::leave, view, state);
    EXPECT_FALSE(isBusy(state)) << int(wish);
  }
}

TEST(Fulfil, atABreakTheBestOtherRunIsShownFirst) {
  View view = sampleView();
  view.comparison.runs.resize(3);
  ViewState state;
  lookAtFault(0, view, state);  // of run 1
  fulfil(Wish::nextOther, view, state);
  EXPECT_EQ(state.other, 0u);
  fulfil(Wish::nextOther, view, state);
  EXPECT_EQ(state.other, 2u);
}

TEST(Fulfil, theOtherRunIsNeverTheShownOne) {
  View view = sampleView();
  view.comparison.runs.resize(3);
  ViewState state;
  state.run = 1;
  EXPECT_EQ(otherRun(view, state), 0u);
  fulfil(Wish::nextOther, view, state);
  EXPECT_EQ(otherRun(view, state), 2u);
  fulfil(Wish::nextOther, view, state);
  EXPECT_EQ(otherRun(view, state), 0u);
  fulfil(Wish::nextRun, view, state);
  fulfil(Wish::nextRun, view, state);
  EXPECT_EQ(state.run, 0u);
  EXPECT_EQ(otherRun(view, state), 1u);
}

TEST(Fulfil, stagesComeOneAfterTheOtherAndThenTheResult) {
  View view = sampleView();
  ViewState state;
  fulfil(Wish::nextStage, view, state);
  EXPECT_FALSE(state.stage) << "runs have no stages here";
  view.stages.emplace();
  fulfil(Wish::nextStage, view, state);
  EXPECT_EQ(state.stage, 0u);
  fulfil(Wish::previousStage, view, state);
  EXPECT_FALSE(state.stage);
  fulfil(Wish::previousStage, view, state);
  EXPECT_EQ(state.stage, 15u);
  fulfil(Wish::nextStage, view, state);
  EXPECT_FALSE(state.stage);
}

TEST(PlayOn, goesToTheEndAndStops) {
  const View view = sampleView();
  ViewState state;
  EXPECT_FALSE(playOn(view, state));
  fulfil(Wish::play, view, state);
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(playOn(view, state));
  EXPECT_EQ(state.frame, 4u);
  EXPECT_FALSE(playOn(view, state));
  fulfil(Wish::play, view, state);
  EXPECT_EQ(state.frame, 0u) << "from the start again";
}

}  // namespace
}  // namespace roomgraph
