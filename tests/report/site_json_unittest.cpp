#include "roomgraph/report/site_json.h"

#include <gtest/gtest.h>

#include "refusal.h"
#include "schemas.h"

namespace roomgraph {
namespace {

std::string complaint(const std::string& text) {
  return test::refusalOf([&] { parseSiteJson(text, "site.json"); });
}

/** A file with a room that has all there can be. */
SiteFile sampleFile() {
  SiteFile file;
  file.nextRoom = 2;
  file.rooms.push_back({"R1", "Kitchen \"old\"", false, {1, 1}, {}, 4, {}, {}});
  file.rooms[0].polygon.outer = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  file.rooms[0].polygon.holes = {{{0.5, 0.5}, {0.5, 1}, {1, 0.5}}};
  file.rooms[0].doors = {{{2, 1}, 0.9, "C1"}, {{0, 1}, 0.8, ""}};
  return file;
}

TEST(SiteFile, isReadAsItWasWritten) {
  const std::string text = siteJson(sampleFile());
  EXPECT_EQ(siteJson(parseSiteJson(text, "site.json")), text);
  EXPECT_EQ(siteJson(parseSiteJson(siteJson({}), "site.json")), siteJson({}));
}

TEST(SiteFile, followsTheSchema) {
  EXPECT_EQ(test::schemaComplaint("site", siteJson(sampleFile())), "");
}

TEST(SiteFile, whatIsBrokenIsNamed) {
  const std::string good = siteJson(sampleFile());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return complaint(text);
  };
  const auto says = [](const std::string& line, const std::string& what) {
    return line.rfind("site.json: " + what, 0) == 0 && line.find('\n') == std::string::npos;
  };
  EXPECT_TRUE(says(complaint(""), "is empty"));
  EXPECT_TRUE(says(complaint(good.substr(0, good.size() / 2)), "is not JSON"));
  EXPECT_TRUE(says(complaint("[]"), "is not JSON"));
  EXPECT_TRUE(says(with("roomgraph/site", "roomgraph/graph"),
                   "is of format roomgraph/graph, and not roomgraph/site"));
  EXPECT_TRUE(says(with("\"version\": 1", "\"version\": 2"), "version "));
  EXPECT_TRUE(says(with("\"room\":2", "\"room\":0"), "next.room "));
  EXPECT_TRUE(says(with("\"kind\":\"room\"", "\"kind\":\"hall\""), "rooms[0].kind "));
  EXPECT_TRUE(says(with("\"id\":\"R1\"", "\"id\":\"\""), "rooms[0].id is empty"));
  EXPECT_TRUE(says(with("\"id\":\"R1\"", "\"id\":7"), "rooms[0].id is not text"));
  EXPECT_TRUE(says(with("\"name\":\"Kitchen", "\"name\":7,\"\":\""), "rooms[0].name "));
  EXPECT_TRUE(says(with("[2.0,2.0]", "[2.0]"), "rooms[0].polygon["));
  EXPECT_TRUE(says(with("[2.0,2.0]", "[2.0,1e300]"),
                   "rooms[0].polygon[2][1] is too far away to be a place"));
  EXPECT_TRUE(says(with("\"doors\":[", "\"doors\":[7,"), "rooms[0].doors[0] is not an object"));
  SiteFile twice = sampleFile();
  twice.rooms.push_back(twice.rooms[0]);
  EXPECT_TRUE(says(complaint(siteJson(twice)), "rooms[1].id is that of another room"));
}

TEST(SiteFile, holdsRoomsAnywhereOnEarth) {
  SiteFile file = sampleFile();
  for (Point& p : file.rooms[0].polygon.outer) p = p + Point{500000, 5400000};  // UTM
  EXPECT_EQ(parseSiteJson(siteJson(file), "site.json").rooms[0].polygon.outer,
            file.rooms[0].polygon.outer);
}

TEST(SiteFile, aRoomWithoutANameIsNamedByItsId) {
  SiteFile file = sampleFile();
  file.rooms[0].name = "";
  EXPECT_EQ(parseSiteJson(siteJson(file), "site.json").rooms[0].name, "R1");
}

}  // namespace
}  // namespace roomgraph
