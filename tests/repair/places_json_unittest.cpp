#include <gtest/gtest.h>

#include "carried_by.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

const Transform2D kMotion{10, -5, 0};

MarkedFile read(const std::string& text) { return geojsonPlaces(text, "route.geojson"); }

std::string feature(const std::string& properties, const std::string& type,
                    const std::string& coordinates, const std::string& more = "") {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}" + more + "}";
}

std::string collection(const std::vector<std::string>& features) {
  std::string text = "{\n\"type\": \"FeatureCollection\",\n\"name\": \"mine\",\n\"features\": [";
  for (const std::string& one : features) text += (&one == &features[0] ? "\n" : ",\n") + one;
  return text + "\n]\n}\n";
}

const std::string kState = R"("state":"carried","error_m":0.05})";

TEST(PlacesGeojson, allButCornersAndStatesStays) {
  const std::string text =
      collection({feature(R"({"z":1,"a":[null,2.0]})", "Point", "[1,2,3]", R"(,"id":7)"),
                  feature(R"({"name":"zone"})", "Polygon", "[[[0,0],[1,0],[1,1],[0,0]]]"),
                  feature("null", "LineString", "[[5,5],[6,5]]")});
  EXPECT_EQ(test::textBy(kMotion, read(text)),
            collection({feature(R"({"z":1,"a":[null,2.0],)" + kState, "Point", "[11.0,-3.0,3]",
                                R"(,"id":7)"),
                        feature(R"({"name":"zone",)" + kState, "Polygon",
                                "[[[10.0,-5.0],[11.0,-5.0],[11.0,-4.0],[10.0,-5.0]]]"),
                        feature("{" + kState, "LineString", "[[15.0,0.0],[16.0,0.0]]")}));
}

TEST(PlacesGeojson, aByteOrderMarkIsNoPartOfIt) {
  EXPECT_TRUE(looksLikeGeojson("\xef\xbb\xbf{}"));
  EXPECT_EQ(read("\xef\xbb\xbf" + collection({feature("{}", "Point", "[1,2]")})).things.size(), 1u);
}

TEST(PlacesGeojson, boxesOfTheOldMapGo) {
  const std::string text = test::textBy(
      kMotion, read(R"({"bbox":[0,0,9,9],"type":"FeatureCollection","name":"mine","features":[)" +
                    feature("{}", "Point", "[1,2]", R"(,"bbox":[1,2,1,2])") + "]}"));
  EXPECT_EQ(text, collection({feature("{" + kState, "Point", "[11.0,-3.0]")}));
}

TEST(PlacesGeojson, featuresAndGeometriesMayBeBare) {
  EXPECT_EQ(test::textBy(kMotion, read(R"({"type":"Point","coordinates":[1,2]})")),
            "{\n\"type\": \"Point\",\n\"coordinates\": [11.0,-3.0],\n\"state\": \"carried\",\n"
            "\"error_m\": 0.05\n}\n");
  EXPECT_EQ(read(feature("{}", "MultiPoint", "[[1,2],[3,4]]")).things[0].places.size(), 2u);
  EXPECT_EQ(read(R"({"type":"GeometryCollection","geometries":[{"coordinates":[1,2]}]})")
                .things[0]
                .places.size(),
            1u);
  EXPECT_TRUE(read(R"({"type":"FeatureCollection","features":[]})").things.empty());
}

TEST(PlacesGeojson, aFeatureThatLiesNowhereStaysAsItIs) {
  const std::string nowhere = R"({"type":"Feature","geometry":null,"properties":{"id":3}})";
  EXPECT_TRUE(read(nowhere).things.empty());
  const MarkedFile file = read(collection({nowhere, feature("{}", "Point", "[1,2]")}));
  ASSERT_EQ(file.things.size(), 1u);
  EXPECT_NE(test::textBy(kMotion, file).find(R"("geometry":null,"properties":{"id":3}})"),
            std::string::npos);
}

TEST(PlacesGeojson, roomsAndPassagesWithoutAnIdHaveTheirNumbers) {
  const MarkedFile file =
      read(collection({feature(R"({"room":3})", "Point", "[0,0]"),
                       feature(R"({"passage":0})", "MultiPoint", "[[4,0],[5,0]]"),
                       feature(R"({"room":3,"name":"Kitchen"})", "Point", "[0,0]")}));
  ASSERT_EQ(file.things.size(), 3u);
  EXPECT_EQ(file.things[0].name, "room 3");
  EXPECT_EQ(file.things[1].name, "passage 0");
  EXPECT_EQ(file.things[2].name, "Kitchen");
}

TEST(PlacesGeojson, edgesOfARouteFollowTheirNodes) {
  const MarkedFile file = read(collection(
      {feature(R"({"id":0})", "Point", "[0,0]"), feature(R"({"id":5})", "Point", "[4,0]"),
       feature(R"({"id":6,"startid":0,"endid":5})", "MultiLineString",
               "[[[0.001,0],[2,1],[3.99,0]]]")}));
  ASSERT_EQ(file.things.size(), 3u);
  EXPECT_EQ(file.things[1].name, "5");
  EXPECT_EQ(file.things[2].places.front(), file.things[0].places[0]);
  EXPECT_EQ(file.things[2].places.back(), file.things[1].places[0]);
  EXPECT_NE(test::textBy(kMotion, file).find("[[[10.0,-5.0],[12.0,-4.0],[14.0,-5.0]]]"),
            std::string::npos);
}

TEST(PlacesGeojson, oldStatesGiveWayToNewOnes) {
  const MarkedFile file =
      read(feature(R"({"reason":"old","state":"gone","k":1})", "Point", "[1,2]"));
  EXPECT_NE(test::textBy({}, file).find(R"({"state":"carried","k":1,"error_m":0.05})"),
            std::string::npos);
}

TEST(PlacesGeojson, whatIsNoGeojsonIsRefused) {
  for (const char* text :
       {"{}", "{\"type\":\"FeatureCollection\"}",
        "{\"type\":\"FeatureCollection\",\"features\":[7]}",
        "{\"type\":\"Point\",\"coordinates\":[1,\"2\"]}", "{\"type\":\"Point\",\"coordinates\":7}",
        "{\"type\":\"Point\",\"coordinates\":[1e9,0]}", "{\"type\":\"Feature\",\"properties\":{}}",
        "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\"}}", "{\"type\":", "{]}"})
    EXPECT_THROW(read(text), DataError) << text;
}

}  // namespace
}  // namespace roomgraph
