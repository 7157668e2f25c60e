#include <gtest/gtest.h>

#include <random>

#include "roomgraph/archive/watch_site.h"

namespace roomgraph {
namespace {

TEST(LastingChange, aDoorThatIsWalledUpIsGoneFromThatNightOn) {
  std::vector<double> doors(60, 3);
  for (std::size_t night = 30; night < doors.size(); ++night) doors[night] = 2;
  doors[11] = 2;  // missed once
  doors[44] = 3;  // and drawn once where there is none
  const auto found = lastingChange(doors, 0.5);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 30U);
  EXPECT_EQ(found->before, 3);
  EXPECT_EQ(found->after, 2);
}

TEST(LastingChange, isSaidFromTheThirdNightOn) {
  EXPECT_FALSE(lastingChange({1, 1, 1, 1, 0, 0}, 0.5));
  const auto found = lastingChange({1, 1, 1, 1, 0, 0, 0}, 0.5);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 4U);
}

TEST(LastingChange, whatComesBackIsNone) {
  EXPECT_FALSE(lastingChange({1, 1, 1, 1, 0, 1, 1, 0, 1, 1, 1, 1}, 0.5));
  EXPECT_FALSE(lastingChange({1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1}, 0.5));
}

TEST(LastingChange, whatIsNeverSteadyIsNone) {
  EXPECT_FALSE(lastingChange({1, 2, 1, 3, 1, 2, 2, 3, 1, 2, 3, 3, 2, 3}, 0.5));
}

TEST(LastingChange, levelsWithinTheToleranceAreTheSame) {
  EXPECT_FALSE(lastingChange({10, 10, 10, 11, 11, 11}, 1.5));
  EXPECT_TRUE(lastingChange({10, 10, 10, 12, 12, 12}, 1.5));
}

TEST(LastingChange, needsThreeOnEachSide) {
  EXPECT_FALSE(lastingChange({}, 0.5));
  EXPECT_FALSE(lastingChange({1, 1, 0, 0, 0, 0}, 0.5));
  EXPECT_FALSE(lastingChange({1, 1, 1}, 0.5, 0));
}

TEST(LastingChanges, aDoorThatIsOpenedAgainHasTwo) {
  std::vector<double> doors(300, 3);
  for (std::size_t night = 100; night < 180; ++night) doors[night] = 2;
  const auto found = lastingChanges(doors, 0.5, 5);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].first, 100U);
  EXPECT_EQ(found[0].after, 2);
  EXPECT_EQ(found[1].first, 180U);
  EXPECT_EQ(found[1].after, 3);
}

TEST(LastingChanges, chanceAloneMakesOneInManyYears) {
  // A door that one map in ten misses, for a year.
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    std::vector<double> doors;
    for (int night = 0; night < 365; ++night) doors.push_back(random() % 10 == 0 ? 2 : 3);
    found += lastingChanges(doors, 0.5, 5).size();
  }
  EXPECT_LE(found, 2U);
}

TEST(LastingChange, chanceAloneHardlyEverMakesOne) {
  // A door that one map in ten misses, for sixty nights.
  int found = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::vector<double> doors;
    for (int night = 0; night < 60; ++night) doors.push_back(random() % 10 == 0 ? 2 : 3);
    found += lastingChange(doors, 0.5).has_value();
  }
  EXPECT_LE(found, 3);
}

}  // namespace
}  // namespace roomgraph
