// Rooms stay rooms when their map is turned against its cells; turned by quarters or mirrored, its
// graph is the same to the last vertex.
#include <gtest/gtest.h>

#include <cmath>

#include "MapText.h"
#include "Pose.h"
#include "random_maps.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/pipeline/extract.h"
#include "same_graph.h"

namespace roomgraph::test {
namespace {

/** Whether a place is free in a building of 9.9 x 7.2 m: between two corridors of 2 m four rooms of
 *  2.4 x 3 m, each with a door of 0.9 m to either, in walls of 0.1 m. */
bool isFreeBetweenCorridors(Point p) {
  if (p.x < 0 || p.x > 9.9 || p.y < 0 || p.y > 7.2) return false;
  const double x = std::fmod(p.x, 2.5);
  if (p.y > 2.1 && p.y < 5.1) return x < 2.4;
  return p.y < 2 || p.y > 5.2 || std::abs(x - 1.2) < 0.45;
}

TEST(Turned, roomsBetweenTwoCorridorsStayRooms) {
  constexpr int kSide = 260;
  constexpr double kCell = 0.05;
  const Point middle{kSide * kCell / 2, kSide * kCell / 2};
  for (const double degrees : {0.0, 7.0, 20.0, 33.0, 45.0}) {
    const Transform2D back = carrying(middle, {4.95, 3.6}, -degrees * M_PI / 180);
    MapText map = painted(kSide, kSide, kCell, {});
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        map.cells[std::size_t(y * kSide + x)] =
            isFreeBetweenCorridors(back({kCell * (x + 0.5), kCell * (y + 0.5)})) ? '.' : '#';
    EXPECT_EQ(extract(greyMap(map), {}).result.rooms.size(), 4u) << degrees;
  }
}

/** Ragged walls and specks, so that much is as wide, as long or as large as something else. */
TEST(Turned, byQuartersOrMirroredAndShiftedRaggedMapsHaveTheSameGraph) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    const MapText map = noisyOffice(seed, 300);
    const RoomGraph reference = extract(greyMap(map), {}).result;
    for (Pose pose : symmetries()) {
      pose.shift = {-17.31, 1234.567};
      const RoomGraph found = extract(greyMap(posed(map, pose)), {}).result;
      const auto there = [&](Point p) { return posed(p, map, pose); };
      EXPECT_EQ(differenceOfGraphs(reference, found, there, 1e-6), "")
          << "seed " << seed << ", " << nameOf(pose);
    }
  }
}

}  // namespace
}  // namespace roomgraph::test
