#include "roomgraph/ledger/name_rooms.h"

#include <gtest/gtest.h>

#include "drawn_house.h"
#include "no_consensus.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/ledger/site_rooms.h"
#include "roomgraph/report/site_json.h"

namespace roomgraph {
namespace {

using test::House;
using test::house;
using test::runOf;

/** The rooms of two equal runs of a house whose first run, and so the site, lies at `pose`. */
std::vector<SiteRoom> roomsOf(const House& drawn, const Transform2D& pose) {
  const roomgraph::Run a = runOf(drawn, "a", pose), b = runOf(drawn, "b", {});
  const Site site{{&a, &b}, {{}, pose}, {0, 1}, {}};
  return siteRooms(site, test::noConsensus(site), {1, 1});
}

const SiteRoom* foundAt(const std::vector<SiteRoom>& rooms, Point p) {
  for (const SiteRoom& room : rooms)
    if (sideOf(room.polygon, p) == Side::inside) return &room;
  return nullptr;
}

const Transform2D kLater{3, -7, 1.1};
const std::vector<Point> kPlaces{{10, 5},  {1.5, 2}, {5, 2},   {9, 2},  {14, 2}, {18, 2},
                                 {2.5, 9}, {6, 9},   {9.5, 9}, {13, 9}, {18, 9}};

/** A hall that is the same after half a turn. */
House symmetricHouse() {
  House h;
  h.rooms.push_back({{0, 4}, {20, 6}, true});
  for (int i = 0; i < 5; ++i) {
    h.rooms.push_back({{4.0 * i + 0.1, 0}, {4.0 * i + 3.9, 3.8}});
    h.doors.push_back({0, h.rooms.size() - 1, {4.0 * i + 2, 3.9}});
    h.rooms.push_back({{4.0 * i + 0.1, 6.2}, {4.0 * i + 3.9, 10}});
    h.doors.push_back({0, h.rooms.size() - 1, {4.0 * i + 2, 6.1}});
  }
  return h;
}

/** Rooms and file take the place of what they were. */
void name(std::vector<SiteRoom>& rooms, SiteFile& file) {
  NamedRooms named = nameRooms(rooms, file, "site.json");
  rooms = std::move(named.rooms), file = std::move(named.file);
}

TEST(NameRooms, aNewFileGetsAllRooms) {
  auto rooms = roomsOf(house(), {});
  SiteFile file;
  name(rooms, file);
  ASSERT_EQ(file.rooms.size(), 11u);
  EXPECT_EQ(file.rooms[0].id, "R1");
  EXPECT_EQ(file.rooms.back().id, "C1");
  EXPECT_EQ(file.nextRoom, 11);
  EXPECT_EQ(file.nextCorridor, 2);
}

TEST(NameRooms, idsAndNamesStayInAnotherFrame) {
  auto before = roomsOf(house(), {}), after = roomsOf(house(), kLater);
  SiteFile file;
  name(before, file);
  file.rooms[3].name = "Kitchen";
  const std::string text = siteJson(file);
  name(after, file);
  EXPECT_EQ(siteJson(file), text) << "nothing is new";
  int kitchens = 0;
  for (const Point p : kPlaces) {
    ASSERT_TRUE(foundAt(before, p) && foundAt(after, kLater(p)));
    EXPECT_EQ(foundAt(before, p)->id, foundAt(after, kLater(p))->id);
    const bool isKitchen = foundAt(after, kLater(p))->name == "Kitchen";
    EXPECT_EQ(isKitchen, foundAt(before, p)->id == file.rooms[3].id);
    kitchens += isKitchen;
  }
  EXPECT_EQ(kitchens, 1);
}

TEST(NameRooms, whatIsGoneStaysAndWhatIsNewGetsANewId) {
  House less = house(), more = house();
  less.rooms.pop_back(), less.doors.pop_back();
  more.rooms.push_back({{20.2, 0}, {24, 3.8}});
  more.doors.push_back({5, 11, {20.1, 2}});
  SiteFile file;
  auto rooms = roomsOf(house(), {});
  name(rooms, file);
  const std::string gone = foundAt(rooms, {18, 9})->id, text = siteJson(file);
  rooms = roomsOf(less, kLater);
  name(rooms, file);
  EXPECT_EQ(siteJson(file), text);
  EXPECT_FALSE(foundAt(rooms, kLater({18, 9})));
  rooms = roomsOf(more, kLater);
  name(rooms, file);
  EXPECT_EQ(file.rooms.size(), 12u);
  EXPECT_EQ(foundAt(rooms, kLater({22, 2}))->id, "R11");
  EXPECT_EQ(foundAt(rooms, kLater({18, 9}))->id, gone) << "seen again";
  // Its place in the file is that of the file's frame, and its door leads to a room of the file.
  const SiteRoom& added =
      *findIf(file.rooms, [](const SiteRoom& room) { return room.id == "R11"; });
  EXPECT_LT(distance(added.center, {22.1, 1.9}), 0.2);
  ASSERT_EQ(added.doors.size(), 1u);
  EXPECT_EQ(added.doors[0].to, foundAt(rooms, kLater({18, 2}))->id);
}

TEST(NameRooms, idsAreNotUsedAgain) {
  SiteFile file;
  auto rooms = roomsOf(house(), {});
  name(rooms, file);
  file.rooms.erase(file.rooms.begin() + 9);  // R10, by the user
  rooms = roomsOf(house(), {});
  name(rooms, file);
  EXPECT_EQ(file.nextRoom, 12);
  EXPECT_FALSE(anyOf(file.rooms, [](const SiteRoom& room) { return room.id == "R10"; }));
}

TEST(NameRooms, anotherSiteIsRefused) {
  SiteFile file;
  auto rooms = roomsOf(house(), {});
  name(rooms, file);
  House other;
  other.rooms = {{{0, 0}, {3, 9}}, {{3.2, 5}, {9, 7}}, {{3.2, 7.2}, {6, 15}}, {{9.2, 3}, {17, 7}}};
  other.doors = {{0, 1, {3.1, 6}}, {1, 2, {4, 7.1}}, {1, 3, {9.1, 6}}};
  rooms = roomsOf(other, {});
  EXPECT_THROW(name(rooms, file), DataError);
}

TEST(NameRooms, aSymmetricSiteIsFoundInItsOldFrameOnly) {
  SiteFile file;
  auto rooms = roomsOf(symmetricHouse(), {});
  name(rooms, file);
  auto again = roomsOf(symmetricHouse(), {});
  name(again, file);
  EXPECT_EQ(file.rooms.size(), 11u);
  auto turnedRooms = roomsOf(symmetricHouse(), kLater);
  EXPECT_THROW(name(turnedRooms, file), DataError);
}

TEST(NameRooms, withoutRoomsNothingHappens) {
  SiteFile file;
  std::vector<SiteRoom> rooms;
  name(rooms, file);
  EXPECT_TRUE(file.rooms.empty());
}

}  // namespace
}  // namespace roomgraph
