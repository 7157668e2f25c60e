#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "roomgraph/graph_files/ros_map.h"

namespace roomgraph {
namespace {

/** The values of a TOML text of tables, strings, numbers and lists on one line, by "table|key". A
 *  key that comes twice is an error. */
std::map<std::string, std::string> valuesOf(const std::string& toml) {
  std::map<std::string, std::string> values;
  std::istringstream in(toml);
  std::string table;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line.front() == '[') {
      EXPECT_EQ(line.back(), ']');
      table = line.substr(1, line.size() - 2);
      continue;
    }
    const auto at = line.find(" = ");
    EXPECT_NE(at, std::string::npos) << line;
    EXPECT_TRUE(values.emplace(table + "|" + line.substr(0, at), line.substr(at + 3)).second);
  }
  return values;
}

SessionMap sample() {
  SessionMap map;
  map.yaml = "run1.yaml", map.picture = "run1.pgm";
  map.frame.width = 10, map.frame.height = 20, map.frame.resolution = 0.05;
  map.frame.origin = {1, 2};
  map.pose = {10, 20, M_PI / 2};
  return map;
}

/** The fields that the viewer's own sessions have, and cannot do without. */
TEST(MapsViewer, sessionsPlaceEachMapByItsOriginInTheSite) {
  const auto values = valuesOf(mapsSession({sample()}));
  const std::string table = "maps.\"run1.yaml\"";
  EXPECT_EQ(values.at("|version"), "\"1.7.0\"");
  EXPECT_EQ(values.at(table + "|visible"), "true");
  EXPECT_EQ(values.at(table + ".meta|image_path"), "\"run1.pgm\"");
  EXPECT_EQ(values.at(table + ".meta|yaml_path"), "\"run1.yaml\"");
  EXPECT_EQ(values.at(table + ".meta|resolution"), "0.05");
  // A quarter turn carries (1, 2) to (-2, 1).
  EXPECT_NEAR(std::stod(values.at(table + ".meta.origin_xy|x")), 8, 1e-12);
  EXPECT_NEAR(std::stod(values.at(table + ".meta.origin_xy|y")), 21, 1e-12);
  EXPECT_EQ(values.at(table + ".meta.origin_theta|s"), "1.0");
  EXPECT_NEAR(std::stod(values.at(table + ".meta.origin_theta|c")), 0, 1e-12);
  for (const char* zero : {".pose.translation|x", ".pose.translation|y", ".pose.rotation|yaw"})
    EXPECT_EQ(values.at(table + zero), "0.0");
}

TEST(MapsViewer, numbersAreFloatsEvenWhenTheyAreWhole) {
  SessionMap map = sample();
  map.pose = {};
  const auto values = valuesOf(mapsSession({map}));
  EXPECT_EQ(values.at("maps.\"run1.yaml\".meta.origin_xy|x"), "1.0");
  EXPECT_EQ(values.at("maps.\"run1.yaml\".meta.origin_theta|c"), "1.0");
}

TEST(MapsViewer, sessionsEndWithTheTableOfLensesThatTheViewerAsksFor) {
  const std::string none = mapsSession({}), end = "\n[grid_lenses]\n";
  EXPECT_EQ(none.substr(none.size() - end.size()), end);
}

TEST(MapsViewer, namesMayHoldAnything) {
  SessionMap map = sample();
  map.yaml = "a\"b\\c\n.yaml";
  const std::string quoted = "\"a\\\"b\\\\c\\u000a.yaml\"";
  EXPECT_EQ(valuesOf(mapsSession({map})).at("maps." + quoted + ".meta|yaml_path"), quoted);
  EXPECT_NE(mapsPoseYaml({}, "a\"b").find("map_frame: \"a\\\"b\"\n"), std::string::npos);
}

TEST(MapsViewer, posesAreThoseOfTheMapInTheSite) {
  EXPECT_EQ(mapsPoseYaml({1.5, -2, 0.25}, "run1"),
            "translation:\n  x: 1.5\n  y: -2\n  z: 0\nrotation:\n  roll: 0\n  pitch: 0\n"
            "  yaw: 0.25\nroot_frame: site\nmap_frame: \"run1\"\n");
}

}  // namespace
}  // namespace roomgraph
