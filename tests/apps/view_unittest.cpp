#include <gtest/gtest.h>

#include "ViewScene.h"
#include "read_place.h"

namespace roomgraph {
namespace {

/** Two runs along a line, the second with a break at its key frame 12 of 30; a room round them. */
View sampleView() {
  View view;
  view.comparison.runs.resize(2);
  view.comparison.runs[0].name = "good", view.comparison.runs[1].name = "torn";
  for (std::size_t r = 0; r < 2; ++r) {
    view.runs.emplace_back();
    view.runs[r].name = view.comparison.runs[r].name;
    for (std::size_t k = 0; k < (r == 0 ? 5u : 30u); ++k) {
      const Transform2D pose{0.5 * double(k), double(r), 0};
      view.comparison.runs[r].path.push_back({k, 1e9 + double(k), pose, 0.1 * double(r)});
      view.runs[r].scans.emplace_back();
      view.runs[r].scans.back().pose = pose;
      view.runs[r].scans.back().walls = {{{pose.x, pose.y + 1}, {0, -1}, 6}};
    }
  }
  view.comparison.breaks = {{"torn", {6, 1}, 0.2, 1, 12, 1e9, TornPose{{6, 1, 0}, {5, 1, -0.2}}},
                            {"good", {1, 0}, 0.1, 0.5, {}, {}, {}}};
  SiteRoom room;
  room.id = room.name = "R1", room.area = 200;
  room.polygon.outer = {{-1, -5}, {19, -5}, {19, 5}, {-1, 5}};
  room.runs.resize(2);
  room.runs[0].run = "good", room.runs[0].sighting = RoomSighting::seen;
  room.runs[1].run = "torn", room.runs[1].sighting = RoomSighting::gone;
  view.comparison.rooms = {room};
  return view;
}

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
  fulfil(Wish::nextBreak, view, state);
  EXPECT_EQ(state.tear, 0u);
  EXPECT_EQ(state.run, 1u);
  EXPECT_EQ(state.frame, 12u);
  fulfil(Wish::nextBreak, view, state);
  EXPECT_EQ(state.tear, 1u);
  EXPECT_EQ(state.run, 0u);
  fulfil(Wish::nextBreak, view, state);
  EXPECT_EQ(state.tear, 0u);
  fulfil(Wish::previousBreak, view, state);
  EXPECT_EQ(state.tear, 1u);
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

TEST(ReadPlace, tellsRoomAndKeyFrame) {
  const View view = sampleView();
  ViewState state;
  state.run = 1;
  const auto lines = readPlace(view, state, {6.1, 1.2});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "(6.10, 1.20) m");
  EXPECT_EQ(lines[1], "room R1, 200.0 m2, in 1 of 2 runs; not in torn");
  EXPECT_EQ(lines[2], "key frame 12 at (6.00, 1.00), time 1000000012.00, error 0.10 m");
  EXPECT_EQ(readPlace(view, state, {50, 50}).size(), 1u);
}

TEST(ReadState, tellsTheBreak) {
  const View view = sampleView();
  ViewState state;
  lookAtBreak(0, view, state);
  const auto lines = readState(view, state);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "torn");
  EXPECT_EQ(lines[2], "break 1 of 2: all behind it is turned by 11.5 deg, shifted by 1.00 m");
}

viz::CSetOfObjects::Ptr setOf(const ViewScene& drawn, const char* name) {
  return std::dynamic_pointer_cast<viz::CSetOfObjects>(drawn.scene()->getByName(name));
}

TEST(ViewScene, theScanIsThatOfTheKeyFrameOrOfAllBefore) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  state.frame = 3;
  drawn.update(state, {});
  const auto cloud = [&] { return setOf(drawn, "key frame")->getByClass<viz::CPointCloud>(); };
  ASSERT_TRUE(cloud());
  EXPECT_EQ(cloud()->size(), 1u);
  state.growsMap = true;
  drawn.update(state, {});
  EXPECT_EQ(cloud()->size(), 4u);
}

TEST(ViewScene, aBreakIsShownInBothPoses) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  drawn.update(state, {});
  EXPECT_FALSE(drawn.scene()->getByName("untorn"));
  lookAtBreak(0, view, state);
  drawn.update(state, {});
  EXPECT_TRUE(drawn.scene()->getByName("drawn"));
  EXPECT_TRUE(drawn.scene()->getByName("untorn"));
  const Box box = drawn.boxAt(view.comparison.breaks[0]);
  EXPECT_TRUE(box.contains({5, 1}) && box.contains({6, 1}));
}

TEST(ViewScene, hiddenLayersAreHidden) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  state.hidden = {"rooms"};
  drawn.update(state, {});
  EXPECT_FALSE(drawn.scene()->getByName("rooms")->isVisible());
  state.hidden = {};
  drawn.update(state, {});
  EXPECT_TRUE(drawn.scene()->getByName("rooms")->isVisible());
}

TEST(ViewScene, flickeringShowsOneRunAfterTheOther) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  state.run = 1;
  fulfil(Wish::flicker, view, state);
  for (int turn = 0; turn < 2; ++turn) {
    drawn.update(state, {});
    EXPECT_EQ(drawn.scene()->getByName("torn")->isVisible(), turn == 0);
    EXPECT_EQ(drawn.scene()->getByName("good")->isVisible(), turn == 1);
    EXPECT_TRUE(flickOn(state));
  }
}

TEST(LoadView, whatIsMissingIsSaid) {
  EXPECT_ANY_THROW(loadView({"no such file.simplemap"}, {}, [](const std::string&) {}));
  EXPECT_ANY_THROW(loadView({"no such file.json"}, {}, [](const std::string&) {}));
}

}  // namespace
}  // namespace roomgraph
