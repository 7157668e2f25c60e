#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "roomgraph/base/Json.h"

namespace roomgraph {
namespace {

using Json = nlohmann::ordered_json;

/** "where: problem" of what is wrong; empty where nothing is. */
std::string broken(const std::string& text, const std::function<void(const JsonNode&)>& read) {
  const Json json = Json::parse(text);
  try {
    read(JsonNode{json, ""});
  } catch (const Broken& broken) {
    return broken.where + ": " + broken.problem;
  }
  return "";
}

TEST(JsonNode, findsMembersAndTheirPlaces) {
  const Json json = Json::parse(R"({"rooms": [{"area": 12.5}, {"area": null}]})");
  const JsonNode top{json, ""};
  const auto rooms = top["rooms"].list();
  ASSERT_EQ(rooms.size(), 2u);
  EXPECT_DOUBLE_EQ(rooms[0]["area"].number(), 12.5);
  EXPECT_TRUE(std::isinf(rooms[1]["area"].numberOrInfinity()));
  EXPECT_EQ(rooms[1]["area"].place, "rooms[1].area");
  EXPECT_TRUE(rooms[0].contains("area"));
  EXPECT_FALSE(rooms[0].contains("id"));
}

TEST(JsonNode, saysWhatIsWrongAndWhere) {
  const std::string text = R"({"rooms": [{"area": "large", "id": 1, "count": -2}]})";
  const auto room = [](const JsonNode& top) { return top["rooms"].list()[0]; };
  EXPECT_EQ(broken(text, [&](auto& top) { room(top)["area"].number(); }),
            "rooms[0].area: is not a number");
  EXPECT_EQ(broken(text, [&](auto& top) { room(top)["door"]; }), "rooms[0]: has no 'door'");
  EXPECT_EQ(broken(text, [&](auto& top) { room(top)["id"].text(); }), "rooms[0].id: is not text");
  EXPECT_EQ(broken(text, [&](auto& top) { room(top)["count"].countBelow(9); }),
            "rooms[0].count: is not a whole number below 9");
  EXPECT_EQ(broken(text, [&](auto& top) { room(top).checkId(0); }),
            "rooms[0].id: is not a whole number below 1");
  EXPECT_EQ(broken(text, [&](auto& top) { room(top).list(); }), "rooms[0]: is not a list");
}

TEST(JsonNode, readsIdsWithinTheirLists) {
  const Json json = Json::parse(R"({"a": 2, "b": null})");
  const JsonNode top{json, ""};
  EXPECT_EQ(readId<RoomId>(top["a"], 3), RoomId(2));
  EXPECT_FALSE(readIdOrNone<RoomId>(top["b"], 3));
  EXPECT_THROW(readId<RoomId>(top["a"], 2), Broken);
  EXPECT_THROW(readId<RoomId>(top["b"], 3), Broken);
}

}  // namespace
}  // namespace roomgraph
