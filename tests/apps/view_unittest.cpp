#include <gtest/gtest.h>

#include "MapText.h"
#include "ViewScene.h"
#include "draw_stage.h"
#include "nudge_fit.h"
#include "read_place.h"
#include "roomgraph/drawing/stage_names.h"

namespace roomgraph {
namespace {

const std::vector<std::string> kTwoRooms = {"###############", "#......#......#", "#......#......#",
                                            "#......#......#", "#.............#", "#......#......#",
                                            "#......#......#", "###############"};

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
      view.runs[r].scans.back().keyFrame = k;
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

/** The same, with walls to draw. */
View viewWithMaps() {
  View view = sampleView();
  const auto map = wallMap(test::gridOf(test::drawn(kTwoRooms, 0.5)), WallMapOptions());
  for (roomgraph::Run& run : view.runs) run.map = map;
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
                          Wish::keys, Wish::nextBreak}) {
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
  lookAtBreak(0, view, state);  // of run 1
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

TEST(NudgeBy, turnsAboutTheMiddleOfTheMap) {
  View view = sampleView();
  for (roomgraph::Run& run : view.runs)
    run.map = wallMap(test::gridOf(test::drawn(kTwoRooms, 0.5)), WallMapOptions());
  ViewState state;
  nudgeBy({1, 0}, 0, view, state);
  EXPECT_EQ(shownPose(view, state, 0).x, 0) << "only while nudging";
  fulfil(Wish::nudge, view, state);
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

TEST(ReadState, measuresWhatWasClicked) {
  const View view = sampleView();
  ViewState state;
  fulfil(Wish::measure, view, state);
  state.corners = {{0, 0}, {3, 4}, {3, 5}};
  EXPECT_EQ(readState(view, state).back(), "measured: 6.00 m, the last piece 1.00 m");
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
  EXPECT_EQ(lines[2],
            "key frame 12 at (6.00, 1.00), time 1000000012.00 (2001-09-09T01:46:52Z), "
            "error 0.10 m");
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

/** The one map of two rooms, extracted. */
View viewOfMap() {
  View view;
  view.comparison.runs.resize(1);
  view.map = test::greyMap(test::drawn(kTwoRooms, 0.5));
  extractAgain(view);
  return view;
}

TEST(ReadPlace, tellsRoomVertexAndPathOfTheOneMap) {
  const View view = viewOfMap();
  const auto room = view.graph->file.graph.rooms.at(0).center;
  const auto lines = readPlace(view, ViewState(), room);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].rfind("room 0, ", 0), 0u) << lines[1];
  EXPECT_EQ(lines[2].rfind("vertex ", 0), 0u) << lines[2];
  EXPECT_EQ(lines[3].rfind("path ", 0), 0u) << lines[3];
}

TEST(DrawStage, eachStageIsDrawnAndCounted) {
  const View view = viewOfMap();
  std::set<std::string> lines;
  for (std::size_t stage = 0; stage < stageNames().size(); ++stage) {
    EXPECT_EQ(drawStage(*view.stages, stage)->empty(), stage == 0) << "the grid is the map itself";
    lines.insert(stageLine(*view.stages, stage));
  }
  EXPECT_EQ(lines.size(), 16u);
  EXPECT_EQ(stageLine(*view.stages, 9),
            "stage 10 of 16 (III-B): rooms, the inner polygons of the alpha shape; 2 rooms");
}

TEST(ExtractAgain, takesTheOptionsOfTheView) {
  View view = viewOfMap();
  EXPECT_EQ(view.graph->file.graph.rooms.size(), 2u);
  view.options.findRooms.minWidth = 50;
  extractAgain(view);
  EXPECT_EQ(view.graph->file.graph.rooms.size(), 0u);
}

viz::CSetOfObjects::Ptr setOf(const ViewScene& drawn, const char* name) {
  return std::dynamic_pointer_cast<viz::CSetOfObjects>(drawn.scene()->getByName(name));
}

viz::CSetOfObjects::Ptr setOf(const viz::CSetOfObjects::Ptr& in, std::size_t i) {
  return in->getByClass<viz::CSetOfObjects>(i);
}

TEST(ViewScene, theScanIsThatOfTheKeyFrameOrOfAllBefore) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  state.frame = 3;
  drawn.update(state);
  const auto cloud = [&] { return setOf(drawn, "key frame")->getByClass<viz::CPointCloud>(); };
  ASSERT_TRUE(cloud());
  EXPECT_EQ(cloud()->size(), 1u);
  state.growsMap = true;
  drawn.update(state);
  EXPECT_EQ(cloud()->size(), 4u);
}

TEST(ViewScene, aBreakIsShownInBothPoses) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  drawn.update(state);
  EXPECT_FALSE(drawn.scene()->getByName("untorn"));
  lookAtBreak(0, view, state);
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("drawn"));
  EXPECT_TRUE(drawn.scene()->getByName("untorn"));
  const Box box = drawn.boxAt(view.comparison.breaks[0]);
  EXPECT_TRUE(box.contains({5, 1}) && box.contains({6, 1}));
}

TEST(ViewScene, aRunMayHaveTheNameOfALayer) {
  View view = sampleView();
  const std::string names[] = {"rooms", "key frame"};
  for (std::size_t i = 0; i < 2; ++i) view.comparison.runs[i].name = names[i];
  view.comparison.runs[1].pose = {3, 4, 0};
  view.comparison.breaks.clear();
  view.runs.clear();  // no walls, so that nothing is theirs
  ViewScene drawn(view);
  const auto outlines = drawn.scene()->getByName("rooms");
  ASSERT_TRUE(outlines);
  const auto colour = outlines->getColor_u8();
  drawn.update(ViewState());
  EXPECT_EQ(outlines->getColor_u8(), colour);
  EXPECT_EQ(drawn.scene()->getByName("key frame")->getPose().x, 0);
}

TEST(ViewScene, atABreakTheNamesOfOthersAreGone) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("breaks")->isVisible());
  lookAtBreak(0, view, state);
  drawn.update(state);
  EXPECT_FALSE(drawn.scene()->getByName("breaks")->isVisible());
  fulfil(Wish::leave, view, state);
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("breaks")->isVisible());
}

TEST(ViewScene, aMapWithoutScansHasNoLayerOfPaths) {
  const View map = viewOfMap(), runs = sampleView();
  const auto hasPaths = [](const std::vector<std::string>& layers) {
    return std::count(layers.begin(), layers.end(), "paths") > 0;
  };
  EXPECT_FALSE(hasPaths(ViewScene(map).layers()));
  EXPECT_TRUE(hasPaths(ViewScene(runs).layers()));
}

TEST(ViewScene, theMapIsDrawnOnlyOnce) {
  View view = viewOfMap();
  ViewScene drawn(view);
  const auto map = drawn.scene()->getByName("map"), rooms = drawn.scene()->getByName("rooms");
  view.options.findRooms.minWidth = 1.5;
  extractAgain(view);
  drawn.drawGraphAgain();
  EXPECT_TRUE(map);
  EXPECT_EQ(drawn.scene()->getByName("map"), map);
  EXPECT_NE(drawn.scene()->getByName("rooms"), rooms);
}

TEST(ViewScene, hiddenLayersAreHidden) {
  const View view = sampleView();
  ViewScene drawn(view);
  ViewState state;
  state.hidden = {"rooms"};
  drawn.update(state);
  EXPECT_FALSE(drawn.scene()->getByName("rooms")->isVisible());
  state.hidden = {};
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("rooms")->isVisible());
}

TEST(ViewScene, flickeringShowsOneRunAfterTheOther) {
  const View view = viewWithMaps();
  ViewScene drawn(view);
  ViewState state;
  state.run = 1;
  fulfil(Wish::flicker, view, state);
  for (int turn = 0; turn < 2; ++turn) {
    drawn.update(state);
    EXPECT_EQ(drawn.scene()->getByName("run torn")->isVisible(), turn == 0);
    EXPECT_EQ(drawn.scene()->getByName("run good")->isVisible(), turn == 1);
    EXPECT_TRUE(flickOn(state));
  }
}

TEST(ViewScene, aStageTakesThePlaceOfTheGraph) {
  const View view = viewOfMap();
  ViewScene drawn(view);
  ViewState state;
  state.stage = 9;
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("map")->isVisible());
  EXPECT_FALSE(drawn.scene()->getByName("vertices")->isVisible());
  EXPECT_FALSE(setOf(drawn, "stage")->empty());
  state.stage.reset();
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("vertices")->isVisible());
  EXPECT_TRUE(setOf(drawn, "stage")->empty());
}

TEST(ViewScene, aBreakCanBeHeldAgainstOneOtherRun) {
  const View view = viewWithMaps();
  ViewScene drawn(view);
  ViewState state;
  lookAtBreak(0, view, state);
  state.other = 0;
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("run good")->isVisible());
  EXPECT_EQ(drawn.scene()->getByName("run good")->getColor_u8(), mrpt::img::TColor(0, 114, 178));
  EXPECT_FALSE(drawn.scene()->getByName("run torn")->isVisible());
}

TEST(ViewScene, showsWhereRunsDisagreeWhenAsked) {
  View view = sampleView();
  std::vector<std::string> hall(20, "#" + std::string(38, '.') + "#");
  hall.front() = hall.back() = std::string(40, '#');
  const auto grid = test::gridOf(test::drawn(hall, 0.1));
  auto other = grid;  // with a pillar
  for (int x = 18; x < 21; ++x) other.cells[other.frame.index({x, 10})] = State::occupied;
  view.runs[0].map = wallMap(grid, WallMapOptions());
  view.runs[1].map = wallMap(other, WallMapOptions());
  ViewScene drawn(view);
  ViewState state;
  drawn.update(state);
  const auto layer = drawn.scene()->getByName("disagreement");
  ASSERT_TRUE(layer);
  EXPECT_FALSE(layer->isVisible());
  fulfil(Wish::disagreement, view, state);
  drawn.update(state);
  EXPECT_TRUE(layer->isVisible());
  const auto squares = setOf(drawn, "disagreement")->getByClass<viz::CSetOfTriangles>();
  ASSERT_TRUE(squares);
  EXPECT_GT(squares->getTrianglesCount(), 0u);
  EXPECT_LT(squares->getTrianglesCount(), 20u) << "only where they do";
}

TEST(ViewScene, aSwipeShowsEachRunOnItsSide) {
  const View view = viewWithMaps();
  ViewScene drawn(view);
  ViewState state;
  fulfil(Wish::swipe, view, state);
  state.swipe = view.runs[0].map.middle().x;
  drawn.update(state);
  const auto swipe = setOf(setOf(drawn, "marks"), 0);
  const auto left = swipe->getByClass<viz::CPointCloud>(0);
  const auto right = swipe->getByClass<viz::CPointCloud>(1);
  ASSERT_GT(left->size(), 5u);
  ASSERT_GT(right->size(), 5u);
  for (std::size_t i = 0; i < left->size(); ++i)
    EXPECT_LT(left->getPoint3Df(i).x, float(*state.swipe));
  for (std::size_t i = 0; i < right->size(); ++i)
    EXPECT_GE(right->getPoint3Df(i).x, float(*state.swipe));
  EXPECT_FALSE(drawn.scene()->getByName("run good")->isVisible());
}

TEST(LoadView, whatIsMissingIsSaid) {
  EXPECT_ANY_THROW(loadView({"no such file.simplemap"}, {}, [](const std::string&) {}));
  EXPECT_ANY_THROW(loadView({"no such file.json"}, {}, [](const std::string&) {}));
}

}  // namespace
}  // namespace roomgraph
