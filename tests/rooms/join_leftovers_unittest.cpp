#include "join_leftovers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "plan.h"

namespace roomgraph::test {
namespace {

/** Two rooms, parted by a wall 0.8 m thick from x = `wall` cells on, with a door of 1 m. */
Inside twoRooms(int width, int wall) {
  return Plan(width, 20).wall(wall, 1, 4, 20).gap(wall, 8, 4, 5).inside();
}

/** The regions left of the wall, in the door, and right of it. */
class DividedRooms {
 public:
  DividedRooms(const Inside& inside, int wall, const SplitAtDoorsOptions& options = {})
      : inside_(inside),
        from_(0.2 * wall),
        to_(0.2 * (wall + 4)),
        regions_(inside.voronoi, inside.isInside, 0.15, 0.1, options) {
    for (std::uint32_t v = 0; v < inside.isInside.size(); ++v) {
      if (!inside.isInside[v]) continue;
      std::optional<std::uint32_t>& first = first_[sideOf(v)];
      if (!first) first = v;
      regions_.join(*first, v);
    }
    regions_.sumAreas();
    regions_.sumWalls(std::vector<std::uint8_t>(inside.voronoi.obstacles.size(), 1));
  }

  void run() { joinLeftovers(regions_); }

  std::uint32_t left() { return regions_.find(*first_[0]); }
  std::uint32_t door() { return regions_.find(*first_[1]); }
  std::uint32_t right() { return regions_.find(*first_[2]); }

 private:
  std::size_t sideOf(std::uint32_t vertex) const {
    const double x = inside_.voronoi.vertices[vertex].place.x;
    return x < from_ ? 0 : x < to_ ? 1 : 2;
  }

  const Inside& inside_;
  double from_, to_;
  RegionGroups regions_;
  std::optional<std::uint32_t> first_[3];
};

TEST(JoinLeftovers, aDoorFrameJoinsTheLargerRoom) {
  const Inside inside = twoRooms(45, 20);
  DividedRooms rooms(inside, 20);
  ASSERT_NE(rooms.door(), rooms.right());
  rooms.run();
  EXPECT_EQ(rooms.door(), rooms.right());
  EXPECT_NE(rooms.left(), rooms.right());
}

TEST(JoinLeftovers, betweenEqualNeighboursNothingIsJoined) {
  // Else the pose of the map would decide.
  const Inside inside = twoRooms(44, 21);
  DividedRooms rooms(inside, 21);
  rooms.run();
  EXPECT_NE(rooms.door(), rooms.left());
  EXPECT_NE(rooms.door(), rooms.right());
}

TEST(JoinLeftovers, whatIsLargeAndLongEnoughStays) {
  const Inside inside = twoRooms(45, 20);
  SplitAtDoorsOptions options;
  options.maxLeftoverArea = options.minElongation = 0;
  DividedRooms rooms(inside, 20, options);
  rooms.run();
  EXPECT_NE(rooms.door(), rooms.left());
  EXPECT_NE(rooms.door(), rooms.right());
}

}  // namespace
}  // namespace roomgraph::test
