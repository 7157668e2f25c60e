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
  const Footprint print = footprint(room, {}, kFrame, run);
  EXPECT_EQ(print.samples, double(room.samples.size()));
  ASSERT_EQ(print.in.size(), 1u);
  EXPECT_NEAR(print.in.at(0) / print.samples, 16.0 / 32, 0.05);
  EXPECT_NEAR(print.bare / print.samples, 12.0 / 32, 0.05);
  EXPECT_NEAR(print.known / print.samples, 28.0 / 32, 0.05);
}

TEST(Footprint, beyondTheFrameNothingIsKnown) {
  const RunAreas run = drawnAreas(kRoom);
  const Footprint print = footprint(run.shapes[0], {{100, 0}, 0}, kFrame, run);
  EXPECT_EQ(print.known, 0);
  EXPECT_TRUE(print.in.empty());
}

TEST(FitShape, aRoomInItsPlaceStays) {
  const RunAreas run = drawnAreas(kRoom);
  const auto fits = fitShape(run.shapes[0], kFrame, run, {{}}, {});
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
  const auto fits = fitShape(room, kFrame, shifted, {{}}, {});
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
  EXPECT_TRUE(fitShape(far, kFrame, drawnAreas(kRoom), {{}}, {}).empty());
  const RoomMove start{{29.8, 0}, 0};
  EXPECT_EQ(fitShape(far, kFrame, drawnAreas(kRoom), {start}, {}).size(), 1u);
}

TEST(FitShape, whereHalfOfItIsUnknownNothingIsSaid) {
  const SiteShape room = drawnAreas(kRoom).shapes[0];
  const RunAreas run =
      drawnAreas({"                ", "   ####         ", "   #AAA         ", "   #AAA         ",
                  "   #AAA         ", "   #AAA         ", "   ####         ", "                "});
  FitShapeOptions here;
  here.reach = 0;
  EXPECT_TRUE(fitShape(room, kFrame, run, {{}}, here).empty());
}

}  // namespace
}  // namespace roomgraph::test
