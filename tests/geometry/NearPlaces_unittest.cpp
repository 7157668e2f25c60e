#include "roomgraph/geometry/NearPlaces.h"

#include <gtest/gtest.h>

#include <set>

namespace roomgraph {
namespace {

std::vector<std::uint32_t> near(const NearPlaces& places, Point at) {
  std::vector<std::uint32_t> found;
  places.forEachNear(at, [&](std::uint32_t i) { found.push_back(i); });
  return found;
}

TEST(NearPlaces, missesNoneInReach) {
  std::vector<Point> lattice;
  for (int x = -20; x <= 20; ++x)
    for (int y = -20; y <= 20; ++y) lattice.push_back({0.37 * x, 0.41 * y});
  constexpr double reach = 1.5;
  const NearPlaces places(lattice, reach);
  for (const Point at : lattice) {
    const std::vector<std::uint32_t> found = near(places, at);
    const std::set<std::uint32_t> each(found.begin(), found.end());
    EXPECT_EQ(each.size(), found.size()) << "one of them is found twice";
    for (std::uint32_t i = 0; i < lattice.size(); ++i) {
      if (distance(lattice[i], at) <= reach) {
        EXPECT_EQ(each.count(i), 1u);
      }
    }
    EXPECT_LT(each.size(), 150u) << "more than the squares around";
  }
}

TEST(NearPlaces, areVisitedBySquareAndIndex) {
  const NearPlaces places({{0.5, 0.5}, {1.5, 0.5}, {0.5, 1.5}, {0.4, 0.4}, {-0.5, 0}, {9, 0}}, 1);
  EXPECT_EQ(near(places, {0.1, 0.9}), (std::vector<std::uint32_t>{4, 0, 3, 2, 1}));
}

TEST(NearPlaces, ofNoneAreNone) { EXPECT_TRUE(near(NearPlaces({}, 1), {0, 0}).empty()); }

}  // namespace
}  // namespace roomgraph
