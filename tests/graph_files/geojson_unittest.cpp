#include "roomgraph/graph_files/geojson.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "sample_stages.h"

namespace roomgraph {
namespace {

using Json = nlohmann::json;

std::string geojsonOf(const Stages& stages) {
  return geojson(stages.result, ObstacleRows(stages.obstacles), stages.clearance,
                 stages.areas.passages);
}

const ObstacleCells kNoObstacle{{1, 1, 1, {}}, {}};

struct Features {
  std::vector<Json> nodes, edges, polygons, passages;
};

/** Sorted by the type of geometry, as nav2's loader does it. */
Features features(const std::string& text) {
  Features sorted;
  const Json json = Json::parse(text);
  for (const Json& feature : json["features"]) {
    const std::string type = feature["geometry"]["type"];
    (type == "Point"             ? sorted.nodes
     : type == "MultiLineString" ? sorted.edges
     : type == "LineString"      ? sorted.edges
     : type == "MultiPoint"      ? sorted.passages
                                 : sorted.polygons)
        .push_back(feature);
  }
  return sorted;
}

TEST(Geojson, idsAreUniqueOverNodesAndEdges) {
  const Features all = features(geojsonOf(sampleStages()));
  std::set<unsigned> ids;
  for (const auto& list : {all.nodes, all.edges})
    for (const Json& feature : list) {
      ASSERT_TRUE(feature["properties"]["id"].is_number_unsigned());
      EXPECT_TRUE(ids.insert(feature["properties"]["id"].get<unsigned>()).second);
    }
  EXPECT_EQ(ids.size(), all.nodes.size() + all.edges.size());
}

TEST(Geojson, verticesComeFirstUnderTheirOwnIds) {
  const Stages stages = sampleStages();
  const RoomGraph& graph = stages.result;
  const Features all = features(geojsonOf(stages));
  ASSERT_GE(all.nodes.size(), graph.graph.vertices().size());
  for (std::size_t v = 0; v < graph.graph.vertices().size(); ++v) {
    EXPECT_EQ(all.nodes[v]["properties"]["id"], v);
    EXPECT_EQ(all.nodes[v]["properties"]["frame"], "map");
    EXPECT_NEAR(all.nodes[v]["geometry"]["coordinates"][0].get<double>(),
                graph.graph.vertices()[v].place.x, 1e-4);
  }
  EXPECT_EQ(all.nodes[0]["properties"]["metadata"]["class"], "room");
}

TEST(Geojson, everyPieceIsThereBothWaysBetweenKnownNodes) {
  const Features all = features(geojsonOf(sampleStages()));
  std::map<unsigned, Json> place;
  for (const Json& node : all.nodes)
    place[node["properties"]["id"].get<unsigned>()] = node["geometry"]["coordinates"];
  std::multiset<std::pair<unsigned, unsigned>> ways;
  for (const Json& edge : all.edges) {
    const unsigned from = edge["properties"]["startid"], to = edge["properties"]["endid"];
    const Json line = edge["geometry"]["coordinates"][0];
    EXPECT_EQ(line[0], place.at(from));
    EXPECT_EQ(line[1], place.at(to));
    ways.insert({from, to});
  }
  for (const auto& [from, to] : ways) EXPECT_EQ(ways.count({from, to}), ways.count({to, from}));
}

TEST(Geojson, aRobotThatDrivesStraightFromNodeToNodeFollowsThePath) {
  const Stages stages = sampleStages();
  const RoomGraph& graph = stages.result;
  std::vector<double> driven(graph.graph.edges().size());
  for (const Json& edge : features(geojsonOf(stages)).edges)
    driven[edge["properties"]["metadata"]["edge"].get<std::size_t>()] +=
        edge["properties"]["cost"].get<double>() / 2;  // forth and back
  for (std::size_t e = 0; e < driven.size(); ++e)
    EXPECT_NEAR(driven[e], graph.graph.edges()[e].path.length, 0.02) << e;
}

TEST(Geojson, roomsAreClosedPolygonsWithTheirHoles) {
  const Features all = features(geojsonOf(sampleStages()));
  ASSERT_EQ(all.polygons.size(), 2u);
  EXPECT_EQ(all.polygons[0]["geometry"]["type"], "Polygon");
  const Json rings = all.polygons[0]["geometry"]["coordinates"];
  ASSERT_EQ(rings.size(), 2u);
  for (const Json& ring : rings) EXPECT_EQ(ring.front(), ring.back());
  EXPECT_EQ(all.polygons[0]["properties"]["area"], 16.31);
}

TEST(Geojson, roomsHaveNoStairsOfOneCell) {
  Stages stages = extractedStages();
  const double cell = ObstacleRows(stages.obstacles).cellSide();
  Ring& outer = stages.result.rooms[0].shape.polygon.outer;
  outer = {{0, 0}, {40 * cell, 0}, {40 * cell, 40 * cell}};
  for (int step = 39; step > 0; --step) {  // down a slanted wall, back to the first corner
    outer.push_back({step * cell, (step + 1) * cell});
    outer.push_back({step * cell, step * cell});
  }
  EXPECT_LE(features(geojsonOf(stages)).polygons[0]["geometry"]["coordinates"][0].size(), 6u);
}

TEST(Geojson, passagesAreTheirTwoEnds) {
  const Stages stages = sampleStages();
  const std::vector<Json> passages = features(geojsonOf(stages)).passages;
  ASSERT_EQ(passages.size(), stages.areas.passages.size());
  EXPECT_EQ(passages[0]["geometry"]["coordinates"], Json({{3.45, 2.55}, {3.45, -1.55}}));
  EXPECT_EQ(passages[0]["properties"], Json({{"passage", 0},
                                             {"width", 4.1},
                                             {"confidence", 0.8765},
                                             {"evidence", "wall_on_both_sides"}}));
  EXPECT_EQ(
      passages[1]["properties"],
      Json({{"passage", 1}, {"width", 0.9552}, {"confidence", 0.0}, {"evidence", "narrowing"}}));
}

/** nav2's loader throws at null, wherever in the properties it is. */
TEST(Geojson, holdsNoNull) {
  EXPECT_EQ(geojsonOf(sampleStages()).find("null"), std::string::npos);
  EXPECT_EQ(geojsonOf(extractedStages()).find("null"), std::string::npos);
}

/** nav2's loader keeps each value of the metadata as the type that it has in JSON, and its scorers
 *  and operations ask for a float: a whole number without a point ends them with bad_any_cast. */
TEST(Geojson, numbersOfTheMetadataAreNoIntegers) {
  const Features all = features(geojsonOf(extractedStages()));
  ASSERT_FALSE(all.edges.empty());
  for (const auto& list : {all.nodes, all.edges})
    for (const Json& feature : list)
      for (const char* key : {"clearance", "length", "min_clearance", "speed_limit", "penalty"})
        if (feature["properties"]["metadata"].contains(key)) {
          EXPECT_TRUE(feature["properties"]["metadata"][key].is_number_float()) << feature;
        }
}

/** The keys that nav2's scorers and operations read by default. */
TEST(Geojson, edgesHaveAClassASpeedLimitAndAPenalty) {
  const Features all = features(geojsonOf(sampleStages()));
  ASSERT_FALSE(all.edges.empty());
  for (const Json& edge : all.edges) {
    const Json metadata = edge["properties"]["metadata"];
    EXPECT_TRUE(metadata["class"] == "room" || metadata["class"] == "way" ||
                metadata["class"] == "corridor");
    const double speed = metadata["speed_limit"];
    EXPECT_NEAR(speed, std::clamp(100 * metadata["min_clearance"].get<double>(), 20.0, 100.0),
                0.51);
    EXPECT_NEAR(metadata["penalty"].get<double>(),
                edge["properties"]["cost"].get<double>() * (100 / speed - 1), 2e-3);
  }
}

/** nav2's loader refuses a graph without nodes or edges. */
TEST(Geojson, aPlaceWithoutAWayGetsOneWithinItsDisc) {
  RoomGraph graph;
  graph.graph = TopologyGraph({{{3, 4}, 2, VertexKind::room, RoomId(0)}}, {});
  const Features all = features(geojson(graph, ObstacleRows(kNoObstacle), 0.1));
  ASSERT_EQ(all.nodes.size(), 2u);
  ASSERT_EQ(all.edges.size(), 2u);
  EXPECT_EQ(all.edges[0]["properties"]["startid"], 0);
  EXPECT_EQ(all.edges[0]["properties"]["cost"], 1);
  EXPECT_EQ(all.edges[0]["properties"]["metadata"]["min_clearance"], 1);
  EXPECT_EQ(all.edges[0]["properties"]["startid"], all.edges[1]["properties"]["endid"]);
}

TEST(Geojson, aStraightPieceStatesItsOwnClearance) {
  // The bend of 0.08 m past a post at (2, 0.3) is cut off.
  RoomGraph graph;
  const Polyline points{{0, 0}, {2, -0.08}, {4, 0}};
  graph.graph =
      TopologyGraph({{{0, 0}, 1, VertexKind::deadEnd, {}}, {{4, 0}, 1, VertexKind::deadEnd, {}}},
                    {{VertexId(0), VertexId(1), {points, {}, length(points), 0.38}, {}}});
  const ObstacleCells post{{40, 40, 0.1, {-0.05, -0.95}}, {{20, 12}}};
  const Features all = features(geojson(graph, ObstacleRows(post), 0.1));
  ASSERT_EQ(all.edges.size(), 2u);
  EXPECT_NEAR(all.edges[0]["properties"]["metadata"]["min_clearance"].get<double>(), 0.3, 1e-9);
  EXPECT_EQ(features(geojson(graph, ObstacleRows(post), 0.35)).edges.size(), 4u) << "too near";
}

TEST(Geojson, ofAnEmptyGraphHasNoFeature) {
  EXPECT_TRUE(Json::parse(geojson({}, ObstacleRows(kNoObstacle), 0.1))["features"].empty());
}

}  // namespace
}  // namespace roomgraph
