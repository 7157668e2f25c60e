#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "roomgraph/report/site_json.h"
#include "sample_comparison.h"

namespace roomgraph {
namespace {

using Json = nlohmann::json;

Comparison sampleSite() {
  Comparison comparison = test::sampleComparison().comparison;
  comparison.rooms[0].doors = {{{3.5, 5}, 1, "C1", {"a"}, {"b"}}, {{0.2, 2}, 0.9, ""}};
  comparison.rooms[4].polygon.holes = {{{2, 6}, {3, 6}, {3, 6.5}}};
  return comparison;
}

TEST(SiteGeojson, roomsSayWhichRunsHaveThem) {
  const Comparison comparison = sampleSite();
  const Json json = Json::parse(siteGeojson(comparison));
  EXPECT_EQ(json["type"], "FeatureCollection");
  std::vector<Json> rooms;
  for (const Json& feature : json["features"])
    if (feature["geometry"]["type"] == "Polygon") rooms.push_back(feature);
  ASSERT_EQ(rooms.size(), 5u);
  EXPECT_EQ(rooms[0]["properties"]["id"], "R1");
  EXPECT_EQ(rooms[0]["properties"]["name"], "Kitchen <b>&amp;</b>");
  EXPECT_EQ(rooms[2]["properties"]["gone_in"], Json({test::kHostileName}));
  EXPECT_EQ(rooms[3]["properties"]["unvisited_in"], Json({"west"}));
  EXPECT_EQ(rooms[3]["properties"]["seen_in"], Json({"morning", "evening", test::kHostileName}));
  EXPECT_EQ(rooms[4]["properties"]["kind"], "corridor");
  EXPECT_EQ(rooms[4]["geometry"]["coordinates"].size(), 2u) << "its hole";
  for (const Json& room : rooms)
    for (const Json& ring : room["geometry"]["coordinates"]) EXPECT_EQ(ring.front(), ring.back());
}

TEST(SiteGeojson, doorsFollowTheirRoom) {
  const Json json = Json::parse(siteGeojson(sampleSite()));
  const Json &inner = json["features"][1], &outer = json["features"][2];
  EXPECT_EQ(inner["geometry"]["coordinates"], Json({3.5, 5.0}));
  EXPECT_EQ(inner["properties"]["room"], "R1");
  EXPECT_EQ(inner["properties"]["to"], "C1");
  EXPECT_EQ(inner["properties"]["seen_in"], Json({"a"}));
  EXPECT_EQ(inner["properties"]["lost_in"], Json({"b"}));
  EXPECT_EQ(outer["properties"]["to"], nullptr);
  EXPECT_EQ(outer["properties"]["width"], 0.9);
}

TEST(SiteGeojson, aSiteWithoutRoomsHasNoFeatures) {
  EXPECT_TRUE(Json::parse(siteGeojson({}))["features"].empty());
}

}  // namespace
}  // namespace roomgraph
