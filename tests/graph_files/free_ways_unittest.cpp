// On any map each edge of each file lies in free space, with the clearance that it states.
#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "blocked.h"
#include "random_maps.h"
#include "roomgraph/graph_files/geojson.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/graph_files/graphml.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph::test {
namespace {

using Json = nlohmann::json;

/** Files have four decimals [m]. */
constexpr double kRounding = 2e-4;

struct StatedWay {
  Polyline points;
  double clearance = 0;
};

using StatedWays = std::vector<StatedWay>;

StatedWays waysOfJson(const Stages& stages) {
  StatedWays ways;
  const Json json = Json::parse(graphJson(stages));
  for (const Json& edge : json["edges"]) {
    ways.push_back({{}, edge["min_clearance"]});
    for (const Json& p : edge["path"]) ways.back().points.push_back({p[0], p[1]});
  }
  return ways;
}

StatedWays waysOfGraphml(const Stages& stages) {
  std::istringstream stream(graphml(stages.result));
  boost::property_tree::ptree tree;
  read_xml(stream, tree);
  StatedWays ways;
  for (const auto& [name, edge] : tree.get_child("graphml.graph")) {
    if (name != "edge") continue;
    ways.emplace_back();
    for (const auto& [tag, data] : edge) {
      const std::string key = data.get("<xmlattr>.key", "");
      if (key == "min_clearance") ways.back().clearance = data.get_value<double>();
      if (key != "path") continue;
      std::istringstream line(data.data().substr(std::string("LINESTRING(").size()));
      for (Point p; line >> p.x >> p.y; line.ignore()) ways.back().points.push_back(p);
    }
  }
  return ways;
}

/** Also tells of nodes that no edge touches. */
StatedWays waysOfGeojson(const Stages& stages) {
  StatedWays ways;
  std::set<std::size_t> nodes, touched;
  const Json json =
      Json::parse(geojson(stages.result, ObstacleRows(stages.obstacles), stages.clearance));
  for (const Json& feature : json["features"]) {
    const Json& properties = feature["properties"];
    if (feature["geometry"]["type"] == "Point") nodes.insert(properties["id"].get<std::size_t>());
    if (feature["geometry"]["type"] != "MultiLineString") continue;
    for (const char* end : {"startid", "endid"}) touched.insert(properties[end].get<std::size_t>());
    ways.push_back({{}, properties["metadata"]["min_clearance"]});
    for (const Json& p : feature["geometry"]["coordinates"][0])
      ways.back().points.push_back({p[0], p[1]});
  }
  EXPECT_EQ(nodes, touched);
  return ways;
}

/** Passages run from obstacle to obstacle: what lies between these. */
std::string faultOf(const Stages& stages, const Passage& passage) {
  const Grid& grid = stages.cleared.grid;
  const auto endCells = {grid.frame.cellAt(passage.from), grid.frame.cellAt(passage.to)};
  const int count = 1 + int(passage.width / (grid.frame.resolution / 4));
  for (int k = 0; k <= count; ++k) {
    const Point p = passage.from + (double(k) / count) * (passage.to - passage.from);
    const Cell cell = grid.frame.cellAt(p);
    const bool isEnd = std::any_of(endCells.begin(), endCells.end(), [&](Cell end) {
      return std::abs(cell.x - end.x) <= 1 && std::abs(cell.y - end.y) <= 1;
    });
    if (!isEnd && !grid.isFree(p)) return "not free" + textOf(p);
  }
  return "";
}

/** The first place of a way that is not free, or nearer to what is not than the way states; empty
 *  where there is none. */
std::string faultOf(const Stages& stages, const StatedWay& way) {
  const bool outsideIsBlocked = isBlockedOutside(stages.grid);
  for (std::size_t i = 0; i + 1 < way.points.size(); ++i) {
    const Point from = way.points[i], to = way.points[i + 1];
    const int count = 1 + int(distance(from, to) / (stages.grid.frame.resolution / 4));
    for (int k = 0; k <= count; ++k) {
      const Point p = from + (double(k) / count) * (to - from);
      if (!stages.grid.isFree(p)) return "not free" + textOf(p);
      const double found = distanceToBlocked(stages.grid, outsideIsBlocked, p, way.clearance);
      if (found < way.clearance - kRounding)
        return std::to_string(found) + " for " + std::to_string(way.clearance) + textOf(p);
    }
  }
  return way.points.size() < 2 ? "no way" : "";
}

void expectFree(const Stages& stages, const StatedWays& ways, const std::string& what) {
  for (const StatedWay& way : ways) {
    const std::string fault = faultOf(stages, way);
    ASSERT_EQ(fault, "") << what;
  }
}

TEST(FreeWays, areInAllFilesOfDrawnMaps) {
  std::size_t lone = 0;
  for (std::uint32_t seed = 1; seed <= 120; ++seed) {
    const MapText map = seed % 8 ? randomMap(seed, 80, 60, 0.1) : noisyOffice(seed, 250);
    const Stages stages = extract(greyMap(map), {});
    const std::vector<GraphRoom>& rooms = stages.result.rooms;
    lone += rooms.size() == 1 && rooms.front().borderVertices.empty() ? 1 : 0;
    const std::string what = "seed " + std::to_string(seed);
    expectFree(stages, waysOfJson(stages), what + " json");
    expectFree(stages, waysOfGraphml(stages), what + " graphml");
    expectFree(stages, waysOfGeojson(stages), what + " geojson");
    for (const Passage& passage : stages.areas.passages)
      EXPECT_EQ(faultOf(stages, passage), "") << what;
  }
  EXPECT_GT(lone, 5u) << "maps of one room without a way out are among them";
}

TEST(FreeWays, theWayOfALoneRoomPassesItsPillars) {
  MapText map = painted(60, 60, 0.1, {});
  for (int y = 8; y < 60; y += 14)
    for (int x = 8; x < 60; x += 14)
      for (int i = 0; i < 25; ++i) map.cells[std::size_t((y + i / 5) * 60 + x + i % 5)] = '#';
  const Stages stages = extract(greyMap(map), {});
  ASSERT_EQ(stages.result.rooms.size(), 1u);
  const StatedWays ways = waysOfGeojson(stages);
  EXPECT_GE(ways.size(), 2u);
  expectFree(stages, ways, "geojson");
}

}  // namespace
}  // namespace roomgraph::test
