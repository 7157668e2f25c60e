#include "ViewScene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "MapText.h"
#include "roomgraph/align/wall_map.h"
#include "sample_view.h"

namespace roomgraph {
namespace {

using test::sampleView;
using test::viewOfMap;
using test::viewWithMaps;

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
  lookAtFault(0, view, state);
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("drawn"));
  EXPECT_TRUE(drawn.scene()->getByName("untorn"));
  const Box box = drawn.boxAt(view.faults[0]);
  EXPECT_TRUE(box.contains({5, 1}) && box.contains({6, 1}));
}

TEST(ViewScene, aSlantedSiteIsShownUpright) {
  View view = sampleView();
  view.turn = M_PI / 2;
  const ViewScene drawn(view);
  const auto& camera = drawn.scene()->getViewport()->getCamera();
  EXPECT_NEAR(std::remainder(double(camera.getAzimuthDegrees()) + 180, 360), 0, 1e-3);
  const Box box = drawn.boxAt(view.faults[0]);
  EXPECT_TRUE(box.contains({-1, 5}) && box.contains({-1, 6})) << "as the screen has it";
  const Point middle = view.onScreen()(Point{camera.getPointingAtX(), camera.getPointingAtY()});
  EXPECT_NEAR(distance(middle, midpoint(drawn.box().low, drawn.box().high)), 0, 1e-3);
}

TEST(ViewScene, aRunMayHaveTheNameOfALayer) {
  View view = sampleView();
  const std::string names[] = {"rooms", "key frame"};
  for (std::size_t i = 0; i < 2; ++i) view.comparison.runs[i].name = names[i];
  view.comparison.runs[1].pose = {3, 4, 0};
  view.comparison.breaks.clear(), view.faults.clear();
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
  EXPECT_TRUE(drawn.scene()->getByName("room names")->isVisible());
  lookAtFault(0, view, state);
  drawn.update(state);
  EXPECT_FALSE(drawn.scene()->getByName("breaks")->isVisible());
  EXPECT_FALSE(drawn.scene()->getByName("room names")->isVisible());
  leave(state);
  drawn.update(state);
  EXPECT_TRUE(drawn.scene()->getByName("breaks")->isVisible());
  EXPECT_TRUE(drawn.scene()->getByName("room names")->isVisible());
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
  flicker(view, state);
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
  lookAtFault(0, view, state);
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
  view.runs[0].map = wallMap(grid);
  view.runs[1].map = wallMap(other);
  ViewScene drawn(view);
  ViewState state;
  drawn.update(state);
  const auto layer = drawn.scene()->getByName("disagreement");
  ASSERT_TRUE(layer);
  EXPECT_FALSE(layer->isVisible());
  showOrHide(kDisagreement, state);
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
  changeMode(Mode::swipe, view, state);
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

}  // namespace
}  // namespace roomgraph
