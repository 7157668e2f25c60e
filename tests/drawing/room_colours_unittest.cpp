#include <gtest/gtest.h>

#include <tuple>

#include "draw_layers.h"

namespace roomgraph {
namespace {

bool operator==(Colour a, Colour b) {
  return std::tie(a.red, a.green, a.blue) == std::tie(b.red, b.green, b.blue);
}

Polygon squareAt(double x, double y) {
  return {{{x, y}, {x + 4, y}, {x + 4, y + 4}, {x, y + 4}}, {}};
}

TEST(RoomColours, neighboursDiffer) {
  std::vector<Polygon> rooms;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 6; ++x) rooms.push_back(squareAt(4.2 * x, 4.2 * y));
  std::vector<const Polygon*> pointers;
  for (const Polygon& room : rooms) pointers.push_back(&room);
  const auto colours = roomColours(pointers);
  ASSERT_EQ(colours.size(), rooms.size());
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    if (r % 6 != 5) {
      EXPECT_FALSE(colours[r] == colours[r + 1]) << r;
    }
    if (r + 6 < rooms.size()) {
      EXPECT_FALSE(colours[r] == colours[r + 6]) << r;
    }
  }
}

TEST(RoomColours, ofNoRoomAreNone) { EXPECT_TRUE(roomColours({}).empty()); }

}  // namespace
}  // namespace roomgraph
