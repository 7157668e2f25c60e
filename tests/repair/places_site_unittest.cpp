#include <gtest/gtest.h>

#include "carried_by.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

std::string site(const std::string& at, const std::string& ring, const std::string& states) {
  return "{\n\"format\": \"roomgraph/site\",\n\"version\": 1,\n\"next\": "
         "{\"room\":2,\"corridor\":1},\n"
         "\"rooms\": [\n{\"id\":\"R1\",\"name\":\"Kitchen\",\"kind\":\"room\"," +
         at + ",\"area_m2\":4,\"polygon\":" + ring + ",\"holes\":[],\"doors\":[{" + at +
         ",\"width\":0.9,\"to\":null}]" + states + "}\n]\n}\n";
}

TEST(PlacesSite, roomsMoveWithTheirOutlinesAndDoors) {
  const std::string before = site("\"x\":1,\"y\":1", "[[0,0],[2,0],[2,2],[0,2]]", "");
  ASSERT_TRUE(looksLikeSite(before));
  const MarkedFile file = sitePlaces(before, "site.json");
  ASSERT_EQ(file.things.size(), 1u);
  EXPECT_EQ(file.things[0].name, "R1");
  EXPECT_EQ(test::textBy({10, 5, 0}, file),
            site("\"x\":11.0,\"y\":6.0", "[[10.0,5.0],[12.0,5.0],[12.0,7.0],[10.0,7.0]]",
                 ",\"state\":\"carried\",\"error_m\":0.05"));
}

TEST(PlacesSite, damagedOnesAreRefused) {
  EXPECT_THROW(sitePlaces("{\"format\": \"roomgraph/site\"}", "site.json"), DataError);
  EXPECT_THROW(sitePlaces(site("\"x\":1", "[]", ""), "site.json"), DataError);
  EXPECT_THROW(sitePlaces(site("\"x\":1,\"y\":2", "[[0,null]]", ""), "site.json"), DataError);
}

}  // namespace
}  // namespace roomgraph
