#include <gtest/gtest.h>

#include "mustache_values.h"
#include "page_tables.h"

namespace roomgraph {
namespace {

/** A room that these runs have, each in one piece and without a change. */
SiteRoom room(const std::string& id, const std::vector<std::string>& runs) {
  SiteRoom room;
  room.id = room.name = id;
  room.area = 12.34;
  for (const std::string& run : runs) {
    room.runs.emplace_back();
    room.runs.back().run = run, room.runs.back().sighting = RoomSighting::seen;
    room.runs.back().pieces = 1;
  }
  return room;
}

std::string shownRows(const std::vector<SiteRoom>& rooms, const std::string& text) {
  return kainjow::mustache::mustache("{{#rooms}}" + text + "{{/rooms}}")
      .render(mustacheValues({{"rooms", roomRows(rooms)}}));
}

TEST(RoomRows, aRoomThatAllHaveAlikeIsTheSame) {
  EXPECT_EQ(
      shownRows({room("R1", {"a", "b"})},
                "{{index}} {{id}} {{kind}} {{area}} {{seen}}/{{of}}{{#isSame}} same{{/isSame}}"),
      "0 R1 room 12.3 2/2 same");
}

TEST(RoomRows, aCorridorIsCalledSo) {
  SiteRoom corridor = room("C1", {"a"});
  corridor.isCorridor = true;
  EXPECT_EQ(shownRows({room("R1", {"a"}), corridor}, "{{index}}{{kind}} "), "0room 1corridor ");
}

TEST(RoomRows, aNameIsShownWhereItWasGiven) {
  SiteRoom kitchen = room("R2", {"a"}), blank = room("R3", {"a"});
  kitchen.name = "Kitchen <1>", blank.name = "";
  EXPECT_EQ(shownRows({room("R1", {"a"}), kitchen, blank}, "{{#hasName}}{{name}}{{/hasName}};"),
            ";Kitchen &lt;1&gt;;;");
}

TEST(RoomRows, sightingsAreCountedAndToldOneByOne) {
  SiteRoom some = room("R1", {"a", "b", "c", "d"});
  some.runs[1].sighting = RoomSighting::gone;
  some.runs[2].sighting = some.runs[3].sighting = RoomSighting::unvisited;
  EXPECT_EQ(shownRows({some},
                      "{{seen}}/{{of}} {{#hasGone}}{{gone}} gone{{/hasGone}}: "
                      "{{#dots}}{{kind}} {{/dots}}"),
            "1/4 1 gone: seen gone unvisited unvisited ");
  EXPECT_EQ(shownRows({some}, "{{#dots}}{{title}};{{/dots}}"),
            "a: seen;b: looked there, no such room;c: has not looked there;"
            "d: has not looked there;");
  EXPECT_EQ(shownRows({some}, "{{#isSame}}same{{/isSame}}"), "") << "not all have seen it";
}

TEST(RoomRows, manySightingsAreNoStripOfDots) {
  const auto isStrip = [](std::size_t runs) {
    return shownRows({room("R1", std::vector<std::string>(runs, "a"))},
                     "{{#isStrip}}strip{{/isStrip}}");
  };
  EXPECT_EQ(isStrip(16), "strip");
  EXPECT_EQ(isStrip(17), "");
}

TEST(RoomRows, theLargestShiftIsNamedWithItsRun) {
  SiteRoom moved = room("R1", {"a", "b", "c"});
  EXPECT_EQ(shownRows({moved}, "{{shift}}{{shiftRun}}"), "–");
  moved.runs[0].shift = 0.2, moved.runs[1].shift = 0.45, moved.runs[2].shift = 0.1;
  EXPECT_EQ(shownRows({moved}, "{{shift}} {{shiftRun}}"), "0.45 b");
}

TEST(RoomRows, changesAreCountedByRuns) {
  SiteRoom changed = room("R1", {"a", "b", "c"});
  changed.runs[0].pieces = 3;
  changed.runs[1].isMerged = changed.runs[2].isMerged = true;
  changed.runs[1].doorsGained = 2;
  changed.runs[0].doorsLost = changed.runs[2].doorsLost = 1;
  EXPECT_EQ(shownRows({changed}, "{{changes}}{{#isSame}}same{{/isSame}}"),
            "split in 1, merged in 2, new door in 1, lost door in 2");
}

TEST(RoomRows, ofNoRoomsThereAreNone) { EXPECT_EQ(shownRows({}, "x"), ""); }

}  // namespace
}  // namespace roomgraph
