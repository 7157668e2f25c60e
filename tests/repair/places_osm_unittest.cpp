#include <gtest/gtest.h>

#include "carried_by.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/graph_files/OsmOrigin.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

const std::string kRoot = "  <node id='-1' lat='0' lon='0'><tag k='name' v='root'/></node>\n";

std::string osm(const std::string& elements) {
  return "<?xml version='1.0' encoding='UTF-8'?>\n<osm version='0.6'>\n" + elements + "</osm>\n";
}

std::string node(const std::string& id, Point at) {
  const OsmOrigin origin;
  return "<node id=\"" + id + "\" version=\"3\" lat=\"" + origin.latitudeText(at) + "\" lon=\"" +
         origin.longitudeText(at) + "\" user=\"A &amp; B\"";
}

TEST(PlacesOsm, nodesMoveAndAllElseStays) {
  const std::string
      way =
          "  <way id='-1'>\n    <nd ref='-2'/><nd ref='-3'/>\n    <tag k='name' v='room "
          "&lt;1&gt;'/>\n  ",
      rest = "</way>\n  <!-- mine -->\n  <relation id='-1'><tag k='state' v='x'/></relation>\n";
  const MarkedFile file = osmPlaces(
      osm(kRoot + node("-2", {1, 2}) + "/>\n" + node("-3", {3, 2}) + "/>\n" + way + rest), "a.osm");
  ASSERT_EQ(file.things.size(), 1u);
  EXPECT_EQ(file.things[0].name, "room <1>");
  EXPECT_LT(distance(file.places[1].pose.shift(), {3, 2}), 1e-3);
  EXPECT_EQ(
      test::textBy({10, 0, 0}, file),
      osm(kRoot + node("-2", {11, 2}) + "/>\n" + node("-3", {13, 2}) + "/>\n" + way +
          "  <tag k=\"state\" v=\"carried\"/>\n    <tag k=\"error_m\" v=\"0.05\"/>\n  " + rest));
}

TEST(PlacesOsm, carriedTwiceIsCarriedOnce) {
  const MarkedFile once = osmPlaces(
      osm(kRoot + node("-2", {1, 2}) + ">\n    <tag k='amenity' v='dock'/>\n  </node>\n"), "a.osm");
  const std::string text = test::textBy({}, once);
  EXPECT_EQ(test::textBy({}, osmPlaces(text, "a.osm")), text);
  EXPECT_NE(text.find("dock"), std::string::npos);
}

TEST(PlacesOsm, aWayWithinAnotherOneIsNone) {
  const std::string nested =
      "  <way id='4'><nd ref='-2'/><nd ref='-3'/><way id='5'><nd ref='-3'/><tag k='name' "
      "v='b'/></way></way>\n";
  const MarkedFile file = osmPlaces(
      osm(kRoot + node("-2", {1, 2}) + "/>\n" + node("-3", {3, 2}) + "/>\n" + nested), "a.osm");
  ASSERT_EQ(file.things.size(), 1u);
  EXPECT_EQ(file.things[0].name, "4");
  EXPECT_NO_THROW(osmPlaces(test::textBy({}, file), "a.osm")) << "is XML";
}

TEST(PlacesOsm, placesAreCountedFromTheRoot) {
  const OsmOrigin origin(53.2, 8.8);
  const std::string text =
      osm("<node id='-1' lat='53.2' lon='8.8'><tag k='name' v='root'/></node>"
          "<node id='-2' lat='" +
          origin.latitudeText({30, 40}) + "' lon='" + origin.longitudeText({30, 40}) + "'/>");
  const MarkedFile file = osmPlaces(text, "a.osm");
  ASSERT_EQ(file.places.size(), 1u);
  EXPECT_LT(distance(file.places[0].pose.shift(), {30, 40}), 1e-3);
}

TEST(PlacesOsm, theRootOfAFarMapTellsWhereItLies) {
  const auto root = [](const std::string& x) {
    return "<node id='-1' lat='0' lon='0'><tag k='name' v='root'/><tag k='roomgraph:x' v='" + x +
           "'/><tag k='roomgraph:y' v='-200000'/></node>";
  };
  const OsmOrigin origin(0, 0, {5400000, -200000});
  const MarkedFile file = osmPlaces(
      osm(root("5400000") + "<node id='-2' lat='" + origin.latitudeText({5400030, -200040}) +
          "' lon='" + origin.longitudeText({5400030, -200040}) + "'/>"),
      "a.osm");
  EXPECT_LT(distance(file.places[0].pose.shift(), {5400030, -200040}), 1e-3);
  const MarkedFile again = osmPlaces(test::textBy({10, 0, 0}, file), "a.osm");
  EXPECT_LT(distance(again.places[0].pose.shift(), {5400040, -200040}), 1e-3);
  for (const char* odd : {"nan", "inf", "-1e99", "far"}) {
    const MarkedFile read = osmPlaces(osm(root(odd) + "<node id='-2' lat='0' lon='0'/>"), "a.osm");
    EXPECT_LT(std::abs(read.places[0].pose.x), 2e7) << odd;
  }
}

TEST(PlacesOsm, whatIsNoOsmIsRefused) {
  for (const std::string& text :
       {std::string("<osm>"), std::string("<html></html>"), osm(""), osm(kRoot + "<node id='-2'/>"),
        osm(kRoot + "<node id='-2' lat='x' lon='0'/>"),
        osm(kRoot + "<node id='-2' lat='9' lon='0'/>"), osm(kRoot + "<way id='\xfc'/>"),
        osm("<node id='-1' lat='90' lon='0'><tag k='name' v='root'/></node>"),
        osm(kRoot + node("-2", {1, 2}) + "/>" + node("-2", {3, 2}) + "/>")})
    EXPECT_THROW(osmPlaces(text, "a.osm"), DataError) << text;
}

}  // namespace
}  // namespace roomgraph
