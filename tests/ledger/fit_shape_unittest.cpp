#include "fit_shape.h"

#include <gtest/gtest.h>

#include "drawn_areas.h"

namespace roomgraph::test {
namespace {

const std::vector<std::string> kRoom{"                ", "   ##########   ", "   #AAAAAAAA#   ",
                                     "   #AAAAAAAA#   ", "   #AAAAAAAA#   ", "   #AAAAAAAA#   ",
                                     "   ##########   ", "                "};

const GridFrame kFrame = frameOf(kRoom);

TEST(Footprint, countsWhatLiesUnderTheRoom) {
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  const RunAreas run =
      drawnAreas({"                ", "   ##########   ", "   #AAAA....#   ", "   #AAAA....#   ",
                  "   #AAAA  ..#   ", "   #AAAA  ..#   ", "   ##########   ", "                "});
  LabelCounts buffer;
  const Footprint print = footprint(room, {}, kFrame, run, buffer);
  EXPECT_EQ(print.samples, double(room.samples.size()));
  ASSERT_EQ(print.in.size(), 1u);
  EXPECT_NEAR(print.in.at(0) / print.samples, 16.0 / 32, 0.05);
  EXPECT_NEAR(print.free / print.samples, 28.0 / 32, 0.05);
  EXPECT_NEAR(print.known / print.samples, 28.0 / 32, 0.05);
}

TEST(Footprint, beyondTheFrameNothingIsKnown) {
  const RunAreas run = drawnAreas(kRoom);
  LabelCounts buffer;
  const Footprint print = footprint(run.shapes[0], {{100, 0}, 0}, kFrame, run, buffer);
  EXPECT_EQ(print.known, 0);
  EXPECT_TRUE(print.in.empty());
}

TEST(FitShape, aRoomInItsPlaceStays) {
  const RunAreas run = drawnAreas(kRoom);
  const auto fits = fitShape(run.shapes[0], kFrame, run, {{}});
  ASSERT_EQ(fits.size(), 1u);
  EXPECT_EQ(fits.at(0).move.shift, (Point{0, 0}));
  EXPECT_EQ(fits.at(0).move.turn, 0);
  EXPECT_DOUBLE_EQ(fits.at(0).overlap, 1);
}

TEST(FitShape, aRoomThatWasDrawnBesideItsPlaceIsFound) {
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  const RunAreas shifted =
      drawnAreas({"   ##########   ", "   #AAAAAAAA#   ", "   #AAAAAAAA#   ", "   #AAAAAAAA#   ",
                  "   #AAAAAAAA#   ", "   ##########   ", "                ", "                "});
  const auto fits = fitShape(room, kFrame, shifted, {{}});
  ASSERT_EQ(fits.size(), 1u);
  EXPECT_NEAR(fits.at(0).move.shift.x, 0, 0.11);
  EXPECT_NEAR(fits.at(0).move.shift.y, 0.5, 0.11);
  EXPECT_GT(fits.at(0).overlap, 0.9);
}

TEST(FitShape, noFartherThanItsReach) {
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  SiteShape far = room;
  for (Point& p : far.samples) p = p + Point{-30, 0};
  far.middle = far.middle + Point{-30, 0};
  EXPECT_TRUE(fitShape(far, kFrame, drawnAreas(kRoom), {{}}).empty());
  const RoomMove start{{29.8, 0}, 0};
  EXPECT_EQ(fitShape(far, kFrame, drawnAreas(kRoom), {start}).size(), 1u);
}

TEST(FitShape, whereHalfOfItIsUnknownNothingIsSaid) {
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  const RunAreas run =
      drawnAreas({"                ", "   ####         ", "   #AAA         ", "   #AAA         ",
                  "   #AAA         ", "   #AAA         ", "   ####         ", "                "});
  const ShapeSearch here{0, 0.8, true};
  EXPECT_TRUE(fitShape(room, kFrame, run, {{}}, here).empty());
}

TEST(FitShape, aTurnedRoomIsFound) {
  const RunAreas run = drawnAreas(kRoom);
  const SiteShape& room = run.shapes[0];
  for (const double turn : {-0.2, 0.1, 0.25}) {
    SiteShape drawn = room;  // where the site has it
    const Transform2D motion = carrying(room.middle, room.middle + Point{0.3, -0.2}, turn);
    for (Point& p : drawn.samples) p = motion(p);
    drawn.middle = motion(room.middle);
    const auto fits = fitShape(drawn, kFrame, run, {{}});
    ASSERT_EQ(fits.size(), 1u) << turn;
    EXPECT_GT(fits.at(0).overlap, 0.93) << turn;
    EXPECT_NEAR(fits.at(0).move.turn, -turn, 0.05) << turn;
    EXPECT_LT(distance(fits.at(0).move.shift, {-0.3, 0.2}), 0.15) << turn;
  }
}

TEST(FitShape, anOverlapIsIntersectionOverUnion) {
  // The run has the left half only, and there is wall where the right one was.
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  const RunAreas half =
      drawnAreas({"                ", "   ##########   ", "   #AAAA#####   ", "   #AAAA#####   ",
                  "   #AAAA#####   ", "   #AAAA#####   ", "   ##########   ", "                "});
  const ShapeSearch here{0, 0.8, false};
  EXPECT_NEAR(fitShape(room, kFrame, half, {{}}, here).at(0).overlap, 0.5, 0.03);
  EXPECT_NEAR(fitShape(half.shapes[0], kFrame, drawnAreas(kRoom), {{}}, here).at(0).overlap, 0.5,
              0.03)
      << "the same the other way round";
}

TEST(FitShape, threeAreasAtMostThoseThatFitBest) {
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  const RunAreas parts =
      drawnAreas({"                ", "   ##########   ", "   #ABBCCCDD#   ", "   #ABBCCCDD#   ",
                  "   #ABBCCCDD#   ", "   #ABBCCCDD#   ", "   ##########   ", "                "});
  const auto fits = fitShape(room, kFrame, parts, {{}}, {0, 0.8, true});
  ASSERT_EQ(fits.size(), 3u);
  EXPECT_EQ(fits.count(0), 0u) << "the narrowest";
  EXPECT_EQ(fits.count(2), 1u) << "the widest";
}

TEST(FitShape, ofTwoStartsTheBetterOneCounts) {
  const RunAreas run = drawnAreas(kRoom);
  const ShapeSearch here{0, 0.8, false};
  const auto fits = fitShape(run.shapes[0], kFrame, run, {{{1, 0}, 0}, {}, {{0, 1}, 0}}, here);
  EXPECT_EQ(fits.at(0).move.shift, (Point{0, 0}));
  EXPECT_DOUBLE_EQ(fits.at(0).overlap, 1);
}

TEST(RoomMove, isAPartOfAMotion) {
  const Transform2D whole{3, -1, 0.7};
  for (const Point middle : {Point{0, 0}, Point{5, 2}}) {
    const Transform2D about = moveOf(whole, middle).about(middle);
    for (const Point p : {Point{1, 1}, Point{-4, 7}}) EXPECT_LT(distance(about(p), whole(p)), 1e-9);
  }
}

}  // namespace
}  // namespace roomgraph::test
