#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_house.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/ledger/name_rooms.h"

namespace roomgraph {
namespace {

AreaGraph areasAt(const Transform2D& pose) { return test::runOf(test::house(), "a", pose).areas; }

/** The name of the area that a place of the house is in. */
std::string nameAt(const AreaGraph& areas, const std::vector<std::string>& names, Point place) {
  for (std::size_t a = 0; a < areas.areas.size(); ++a)
    if (sideOf(areas.areas[a].polygon, place) == Side::inside) return names.at(a);
  return "";
}

TEST(NameAreas, roomsOfAFileKeepTheirNamesInAnotherFrame) {
  const Transform2D pose{3, -7, 1.1};
  const AreaGraph before = areasAt({}), after = areasAt(pose);
  NamedAreas named = nameAreas(before, {}, "site.json");
  EXPECT_EQ(nameAt(before, named.names, {10, 5}), "C1");
  const std::string kitchen = nameAt(before, named.names, {1.5, 2});
  for (SiteRoom& room : named.file.rooms)
    if (room.id == kitchen) room.name = "Kitchen";
  const NamedAreas again = nameAreas(after, named.file, "site.json");
  EXPECT_EQ(nameAt(after, again.names, pose({1.5, 2})), "Kitchen");
  EXPECT_EQ(nameAt(after, again.names, pose({5, 2})), nameAt(before, named.names, {5, 2}));
  EXPECT_EQ(again.file.rooms.size(), named.file.rooms.size());
}

TEST(NameAreas, idsTellRoomsOfOneNameApart) {
  const AreaGraph areas = areasAt({});
  NamedAreas named = nameAreas(areas, {}, "site.json");
  for (SiteRoom& room : named.file.rooms) room.name = "Office";
  std::vector<std::string> names = nameAreas(areas, named.file, "site.json").names;
  EXPECT_EQ(names[0].rfind("Office (", 0), 0u) << names[0];
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_TRUE(nameAreas({}, {}, "site.json").names.empty());
}

TEST(NameAreas, anotherBuildingIsRefused) {
  SiteFile file;
  const Ring square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  file.rooms.push_back({"R1", "R1", false, {0, 0}, {square, {}}, 4, {}, {}});
  EXPECT_THROW(nameAreas(areasAt({50, 50, 0.3}), file, "site.json"), DataError);
}

}  // namespace
}  // namespace roomgraph
