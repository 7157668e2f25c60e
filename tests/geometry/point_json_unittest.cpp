#include "roomgraph/geometry/point_json.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

using Json = nlohmann::ordered_json;

TEST(Rounded, roundsBothCoordinates) {
  EXPECT_EQ(rounded(Point{0.00016, -2}), (Point{0.0002, -2}));
}

TEST(ReadPoint, refusesWhatIsNoPair) {
  const Json json = Json::parse(R"({"at": [1]})");
  try {
    readPoint(JsonNode{json, ""}["at"]);
    FAIL();
  } catch (const Broken& broken) {
    EXPECT_EQ(broken.where + ": " + broken.problem, "at: is not a pair [x, y]");
  }
}

TEST(ReadPoint, refusesWhatIsTooFarAway) {
  const Json json = Json::parse(R"({"at": [-1e7, 1e7], "far": [0, 1e308]})");
  EXPECT_EQ(readPoint(JsonNode{json, ""}["at"]), (Point{-1e7, 1e7}));
  EXPECT_THROW(readPoint(JsonNode{json, ""}["far"]), Broken);
}

TEST(ReadPolygon, readsRings) {
  const Json json =
      Json::parse(R"({"polygon": [[0,0],[4,0],[0,3]], "holes": [[[1,1],[1,2],[2,1]]]})");
  const Polygon polygon = readPolygon({json, ""});
  EXPECT_EQ(polygon.outer.size(), 3u);
  ASSERT_EQ(polygon.holes.size(), 1u);
  EXPECT_EQ(polygon.holes[0][1], (Point{1, 2}));
}

TEST(AddPoints, writesPairs) {
  std::string json;
  addPoints(json, {{1, 2}, {-0.5, 1e-9}});
  EXPECT_EQ(json, "[[1,2],[-0.5,0]]");
  json.clear();
  addPoints(json, {});
  EXPECT_EQ(json, "[]");
}

}  // namespace
}  // namespace roomgraph
