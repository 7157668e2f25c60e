#include <gtest/gtest.h>

#include <algorithm>

#include "reform_site.h"
#include "roomgraph/base/Error.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::squareRoom;

std::vector<std::string> idsOf(const Comparison& comparison) {
  std::vector<std::string> ids;
  for (const SiteRoom& room : comparison.rooms) ids.push_back(room.id);
  return ids;
}

/** What is known after a first comparison of three runs. */
struct NameKnownRooms : testing::Test {
  SiteFile ledger;
  Comparison first = test::night("s", "a", 1, 0.1, {"2", "3"}).comparison;

  NameKnownRooms() { nameKnownRooms(first, ledger, "a.db"); }
};

TEST_F(NameKnownRooms, aRoomOfOneRunIsNotRememberedOneOfTwoIs) {
  ASSERT_EQ(ledger.rooms.size(), 3U);

  Comparison torn = test::night("s", "a", 4, 0.1, {"2", "3"}).comparison;
  torn.rooms.push_back(squareRoom("R4", {20, 20}, {"4"}));
  nameKnownRooms(torn, ledger, "a.db");
  EXPECT_EQ(ledger.rooms.size(), 3U);
  EXPECT_EQ(idsOf(torn), (std::vector<std::string>{"R1", "R2", "R3"}));

  Comparison real = test::night("s", "a", 5, 0.1, {"2", "3"}).comparison;
  real.rooms.push_back(squareRoom("R4", {20, 20}, {"5", "2"}));
  nameKnownRooms(real, ledger, "a.db");
  EXPECT_EQ(ledger.rooms.size(), 4U);
}

TEST_F(NameKnownRooms, aKnownRoomThatOneRunStillHasIsTold) {
  Comparison later = first;
  later.rooms[2].runs.resize(1);
  nameKnownRooms(later, ledger, "a.db");
  EXPECT_EQ(idsOf(later), idsOf(first));
}

TEST_F(NameKnownRooms, theRoomsOfTheFirstTwoRunsAreTakenAsTheyAre) {
  SiteFile fresh;
  Comparison alone = test::night("s", "a", 1, 0.1).comparison;
  nameKnownRooms(alone, fresh, "a.db");
  EXPECT_EQ(fresh.rooms.size(), 3U);
}

TEST_F(NameKnownRooms, namesThatPeopleGaveStay) {
  ledger.rooms[1].name = "Kitchen";
  const std::string id = ledger.rooms[1].id;
  Comparison later = test::night("s", "a", 4, 0.1, {"2", "3"}).comparison;
  std::rotate(later.rooms.begin(), later.rooms.begin() + 1, later.rooms.end());
  for (std::size_t r = 0; r < 3; ++r) later.rooms[r].id = "R" + std::to_string(r + 1);
  nameKnownRooms(later, ledger, "a.db");
  ASSERT_EQ(ledger.rooms.size(), 3U);
  for (const SiteRoom& room : later.rooms)
    EXPECT_EQ(room.id == id, room.name == "Kitchen") << room.id;
}

TEST_F(NameKnownRooms, whereTheRoomsLieNowhereNothingIsChanged) {
  Comparison other = test::night("s", "a", 4, 0.1, {"2", "3"}).comparison;
  other.rooms = {squareRoom("R1", {500, 500}, {"1", "2"})};
  const std::size_t rooms = ledger.rooms.size();
  EXPECT_THROW(nameKnownRooms(other, ledger, "a.db"), DataError);
  EXPECT_EQ(ledger.rooms.size(), rooms);
  EXPECT_EQ(idsOf(other), (std::vector<std::string>{"R1"}));
}

}  // namespace
}  // namespace roomgraph
