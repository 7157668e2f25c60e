#include "roomgraph/evaluation/write_stability.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** Two rows of one run each; the second without any value. */
Stability sample() {
  Stability s;
  s.options.distances = {3};
  s.options.percents = {2, 5};
  s.options.repeats = 1;
  s.source.file = "folder/a.png";
  s.source.sha256 = "abc";
  s.frame = {10, 20, 0.5, {}};
  s.baseRooms = 4;
  s.runs = stabilityRuns(s.options);
  s.measures.resize(2);
  StabilityRow row;
  row.distance = 3;
  row.percent = 2;
  row.room = {1.0, {0.25, 0.5, 0.125, 0.0}};
  row.noRoom = {3.0, {1.0, 2.0, 0.5, 0.75}};
  row.ratio = 1.0 / 3;
  row.roomsFound = 0.75;
  row.roomsChange = 1.5;
  StabilityRow empty;
  empty.distance = 3;
  empty.percent = 5;
  s.rows = {row, empty};
  s.mean = row;
  return s;
}

TEST(StabilityCsv, hasThePapersColumnsFirstInCellsAndPercent) {
  EXPECT_EQ(stabilityCsv(sample()),
            "distance_px,percent,room,no_room,ratio_percent,room_median,no_room_median,room_p90,"
            "no_room_p90,room_unmatched_base_percent,no_room_unmatched_base_percent,"
            "room_unmatched_other_percent,no_room_unmatched_other_percent,rooms_found_percent,"
            "rooms_change\n"
            "3,2,2,6,33.3333,0.5000,2,1,4,12.5000,50,0,75,75,1.5000\n"
            "3,5,,,,,,,,,,,,,0\n");
}

TEST(StabilityJson, saysWhatWasMeasuredAndHow) {
  const std::string json = stabilityJson(sample());
  const auto has = [&](const char* text) {
    EXPECT_NE(json.find(text), std::string::npos) << text << " is not in\n" << json;
  };
  has("\"format\": \"roomgraph/stability\"");
  has("\"file\":\"a.png\",\"sha256\":\"abc\"");
  has("\"seed\":1");
  has("\"find_rooms\":{\"min_width\":");
  has("{\"distance_px\":3,\"percent\":2,\"room\":2,\"no_room\":6,\"ratio_percent\":33.3333,");
  has("{\"distance_px\":3,\"percent\":5,\"room\":null,");
}

TEST(StabilityText, isThePapersTableWithTheMeanBelow) {
  const std::string text = stabilityText(sample());
  EXPECT_EQ(text.substr(0, text.find("One to one")),
            "distance [px]  percent  room [px]   no room ratio [%]\n"
            "            3        2       2.00      6.00     33.33\n"
            "            3        5          -         -         -\n"
            "mean of 2 rows               2.00      6.00     33.33\n");
  EXPECT_NE(text.find("Rooms found again 75.0 %, change in their number 1.50 of 4\n"),
            std::string::npos);
}

}  // namespace
}  // namespace roomgraph
