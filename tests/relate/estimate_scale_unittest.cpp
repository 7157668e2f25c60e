#include "roomgraph/relate/estimate_scale.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

using test::drawnBuilding;

constexpr double kCell = 0.05;  // of drawnBuilding [m]
const test::Seen kWest{-1e9, 15};

roomgraph::Run scaledRun(const Grid& grid) {
  roomgraph::Run run;
  run.map = wallMap(grid);
  return run;
}

std::optional<ScaleEstimate> estimated(const Grid& picture,
                                       const std::vector<roomgraph::Run>& runs) {
  return estimateScale(picture, runs, oneByOne);
}

/** The building as a picture that claims to have cells of `guess`. */
Grid pictureOf(std::uint32_t seed, double guess, const test::Seen& seen = {}) {
  return rescaled(drawnBuilding(seed, {0, 0, 1.1}, seen), guess);
}

void expectScale(const std::optional<ScaleEstimate>& found, double resolution, double share) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->resolution / resolution, 1, share);
}

TEST(EstimateScale, findsTheScaleFromAnyGuess) {
  const std::vector<roomgraph::Run> runs{scaledRun(drawnBuilding(1, {3, -4, 0.4}))};
  std::vector<double> scales;
  for (const double guess : {0.02, 0.1}) {
    const auto found = estimated(pictureOf(1, guess), runs);
    expectScale(found, kCell, 0.005);
    ASSERT_TRUE(found);
    scales.push_back(found->resolution);
  }
  EXPECT_NEAR(scales[0], scales[1], 1e-6);
}

TEST(EstimateScale, theRunsTellHowLargeTheBuildingIs) {
  const double factor = 0.65;
  const std::vector<roomgraph::Run> runs{
      scaledRun(rescaled(drawnBuilding(2, {3, -4, 0.4}), factor * kCell))};
  expectScale(estimated(pictureOf(2, kCell), runs), factor * kCell, 0.005);
}

TEST(EstimateScale, aRunThatHasSeenAPartIsEnough) {
  const std::vector<roomgraph::Run> runs{scaledRun(drawnBuilding(4, {3, -4, 0.4}, kWest))};
  expectScale(estimated(pictureOf(4, 0.03), runs), kCell, 0.007);
}

TEST(EstimateScale, aDrawingMayBeFreeAllRound) {
  const std::vector<roomgraph::Run> runs{scaledRun(drawnBuilding(1, {3, -4, 0.4}, kWest))};
  Grid picture = pictureOf(1, 0.03, kWest);
  std::replace(picture.cells.begin(), picture.cells.end(), State::unknown, State::free);
  expectScale(estimated(picture, runs), kCell, 0.005);
}

TEST(EstimateScale, anotherBuildingFitsAtNoScale) {
  EXPECT_FALSE(estimated(pictureOf(8, kCell), {scaledRun(drawnBuilding(1, {}))}));
}

TEST(EstimateScale, aPictureOfTooSmallAPartTellsNothing) {
  const std::vector<roomgraph::Run> runs{scaledRun(drawnBuilding(1, {}))};
  EXPECT_FALSE(estimated(pictureOf(1, kCell, {-1e9, 4}), runs));
}

TEST(EstimateScale, looksInAnotherRunWhereTheFirstIsOfAnotherSite) {
  std::vector<roomgraph::Run> runs{scaledRun(drawnBuilding(1, {0, 0, 2}, kWest)),
                                   scaledRun(drawnBuilding(11, {}, kWest))};
  runs[1].map.axisDeviation = 0;  // it is looked in first
  const auto found = estimated(pictureOf(1, 0.04, kWest), runs);
  expectScale(found, kCell, 0.005);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->runs, 1u);
}

TEST(EstimateScale, oneStretchedRunIsOutvoted) {
  std::vector<roomgraph::Run> runs{scaledRun(rescaled(drawnBuilding(1, {1, 2, 0.1}), 1.02 * kCell)),
                                   scaledRun(drawnBuilding(1, {0, 1, -1.2})),
                                   scaledRun(drawnBuilding(1, {3, -4, 0.4}))};
  runs[0].map.axisDeviation = 0;  // it is looked in first
  const auto found = estimated(pictureOf(1, 0.05), runs);
  expectScale(found, kCell, 0.005);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->runs, 3u);
}

TEST(EstimateScale, theOrderOfRunsAndJobsChangesNothing) {
  std::vector<roomgraph::Run> runs{scaledRun(drawnBuilding(1, {1, 2, 0.1}, kWest)),
                                   scaledRun(drawnBuilding(1, {0, 1, -1.2}, kWest))};
  const Grid picture = pictureOf(1, 0.03, kWest);
  const auto one = estimated(picture, runs);
  std::swap(runs[0], runs[1]);
  const auto other = estimateScale(picture, runs, [](std::size_t count, const auto& job) {
    for (std::size_t i = count; i-- > 0;) job(i);
  });
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->resolution, other->resolution);
}

TEST(EstimateScale, whatHasNoWallsHasNoScale) {
  const Grid picture = pictureOf(1, 0.05);
  Grid blank = picture;
  std::fill(blank.cells.begin(), blank.cells.end(), State::free);
  EXPECT_FALSE(estimated(picture, {}));
  EXPECT_FALSE(estimated(picture, {scaledRun(blank)}));
  EXPECT_FALSE(estimated(blank, {scaledRun(picture)}));
  EXPECT_FALSE(estimated(rescaled({{0, 0, 0.05, {}}, {}}, 0.1), {scaledRun(picture)}));
}

TEST(UsualScale, doesNotDependOnWhatThePicturesClaim) {
  const auto usual = usualScale({pictureOf(1, 0.02)});
  ASSERT_TRUE(usual);
  EXPECT_GT(*usual, kCell / 2);
  EXPECT_LT(*usual, kCell * 2);
  EXPECT_EQ(usualScale({pictureOf(1, 0.1)}), usual);
  EXPECT_FALSE(usualScale({Grid{{3, 3, 1, {}}, std::vector<State>(9, State::occupied)}}));
}

}  // namespace
}  // namespace roomgraph
