#include "roomgraph/graph_files/graph_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "TestFolder.h"
#include "sample_stages.h"
#include "schemas.h"

namespace roomgraph {
namespace {

using Json = nlohmann::json;

/** Where the text breaks the schema; empty where it does not. */
std::string schemaComplaint(const std::string& text) {
  return test::schemaComplaint("graph", text);
}

TEST(GraphJson, ofASampleFollowsTheSchema) {
  EXPECT_EQ(schemaComplaint(graphJson(sampleStages())), "");
}

TEST(GraphJson, ofAnExtractionFollowsTheSchema) {
  const Stages stages = extractedStages();
  ASSERT_EQ(stages.result.rooms.size(), 2u);
  EXPECT_EQ(schemaComplaint(graphJson(stages)), "");
}

TEST(GraphJson, ofAnEmptyResultFollowsTheSchema) {
  Stages stages = sampleStages();
  stages.result = {};
  stages.areas = {};
  stages.notes.clear();
  EXPECT_EQ(schemaComplaint(graphJson(stages)), "");
}

TEST(GraphJson, whatIsBrokenBreaksTheSchema) {
  const Json good = Json::parse(graphJson(sampleStages()));
  const auto complaint = [&](const char* place, const Json& value) {
    Json broken = good;
    broken[Json::json_pointer(place)] = value;
    return schemaComplaint(broken.dump());
  };
  ASSERT_EQ(schemaComplaint(good.dump()), "");
  for (const char* name : {"format", "version", "program", "input", "options", "vertices", "edges",
                           "rooms", "notes"}) {
    Json broken = good;
    broken.erase(name);
    EXPECT_NE(schemaComplaint(broken.dump()), "") << name;
  }
  EXPECT_NE(complaint("/version", 2), "");
  EXPECT_NE(complaint("/input/sha256", "abc"), "");
  EXPECT_NE(complaint("/input/resolution", 0), "");
  EXPECT_NE(complaint("/vertices/0/kind", "door"), "");
  EXPECT_NE(complaint("/vertices/0/room", -1), "");
  EXPECT_NE(complaint("/vertices/0/x", nullptr), "");
  EXPECT_NE(complaint("/edges/0/path/0", Json::array({1.0})), "");
  EXPECT_NE(complaint("/edges/0/source", "n0"), "");
  EXPECT_NE(complaint("/rooms/0/polygon", Json::array()), "");
  EXPECT_NE(complaint("/areas/0/kind", "hall"), "");
  EXPECT_NE(complaint("/areas/0/holes", nullptr), "");
  EXPECT_NE(complaint("/passages/0/areas", Json::array({1})), "");
  EXPECT_NE(complaint("/passages/0/ends/0", Json::array({1.0})), "");
  EXPECT_NE(complaint("/passages/0/confidence", 1.5), "");
  EXPECT_NE(complaint("/passages/0/evidence", "door"), "");
}

TEST(GraphJson, areasAndPassagesAreAlwaysThere) {
  for (const char* key : {"areas", "passages"}) {
    Json json = Json::parse(graphJson(sampleStages()));
    json.erase(key);
    EXPECT_NE(schemaComplaint(json.dump()), "") << key;
  }
  for (const char* key : {"confidence", "evidence"}) {
    Json json = Json::parse(graphJson(sampleStages()));
    json["passages"][1].erase(key);
    EXPECT_NE(schemaComplaint(json.dump()), "") << key;
  }
}

TEST(GraphJson, holdsAreasAndPassages) {
  const Json json = Json::parse(graphJson(sampleStages()));
  ASSERT_EQ(json["areas"].size(), 3u);
  EXPECT_EQ(json["areas"][1]["kind"], "room");
  EXPECT_EQ(json["areas"][1]["room"], 1);
  EXPECT_EQ(json["areas"][1]["area"], json["rooms"][1]["area"]);
  EXPECT_EQ(json["areas"][1]["passages"], Json({0, 1}));
  EXPECT_EQ(json["areas"][0]["holes"], json["rooms"][0]["holes"]);
  EXPECT_EQ(json["areas"][2]["kind"], "corridor");
  EXPECT_TRUE(json["areas"][2]["room"].is_null());
  EXPECT_EQ(json["areas"][2]["inscribed_radius"], 0.5);
  EXPECT_EQ(json["areas"][2]["widest_place"], Json({8.5, 0.5}));
  EXPECT_EQ(json["areas"][2]["polygon"].size(), 4u);
  EXPECT_NEAR(json["areas"][2]["area"].get<double>(), 1.8 * 0.95, 1e-9);
  EXPECT_EQ(json["passages"][1], Json({{"id", 1},
                                       {"areas", {1, 2}},
                                       {"ends", {{7.55, 0.95}, {7.65, 0.0}}},
                                       {"middle", {7.6, 0.475}},
                                       {"width", 0.9552},
                                       {"confidence", 0.0},
                                       {"evidence", "narrowing"}}));
  EXPECT_EQ(json["passages"][0]["confidence"], 0.8765);
  EXPECT_EQ(json["passages"][0]["evidence"], "wall_on_both_sides");
}

TEST(GraphJson, ofADoorToUnseenSpaceFollowsTheSchema) {
  Stages stages = sampleStages();
  stages.areas.passages[1].b = AreaId::none();
  stages.areas.areas[0].seen = 0.625;
  const std::string text = graphJson(stages);
  EXPECT_EQ(schemaComplaint(text), "");
  const Json json = Json::parse(text);
  EXPECT_EQ(json["passages"][1]["areas"], Json({1, nullptr}));
  EXPECT_EQ(json["areas"][0]["seen"], 0.625);
  EXPECT_TRUE(json["areas"][1]["seen"].is_null());
}

TEST(GraphJson, holdsWhatTheGraphHolds) {
  const Json json = Json::parse(graphJson(sampleStages()));
  EXPECT_EQ(json["format"], "roomgraph/graph");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["input"]["file"], "two rooms.png");
  EXPECT_EQ(json["input"]["size"], Json({110, 50}));
  EXPECT_EQ(json["input"]["origin"], Json({-1, -2}));
  EXPECT_FALSE(json["input"].contains("insertion"));
  EXPECT_EQ(json["vertices"][0], Json({{"id", 0},
                                       {"kind", "room"},
                                       {"x", 1.45},
                                       {"y", 0.5},
                                       {"clearance", 1.2346},
                                       {"room", 0}}));
  EXPECT_EQ(json["vertices"][5]["kind"], "dead_end");
  EXPECT_TRUE(json["vertices"][5]["room"].is_null());
  EXPECT_EQ(json["edges"][0]["kind"], "room");
  EXPECT_EQ(json["edges"][3]["kind"], "corridor");
  EXPECT_EQ(json["edges"][3]["path"], Json({{7.6, 0.5}, {8, 0.7}, {8.4, 0.5}}));
  EXPECT_EQ(json["rooms"][0]["holes"].size(), 1u);
  EXPECT_NEAR(json["rooms"][0]["area"].get<double>(), 4 * 4.1 - 0.09, 1e-9);
  EXPECT_EQ(json["rooms"][1]["border_vertices"], Json({2, 3}));
  EXPECT_EQ(json["notes"][0]["x"], 1);
  EXPECT_EQ(json["notes"][0]["y"], 2);
  EXPECT_TRUE(json["notes"][1]["x"].is_null());
}

TEST(GraphJson, holdsEveryOptionWithItsType) {
  Stages stages = sampleStages();
  stages.options.findRooms.minWidth = 2.25;
  const Json json = Json::parse(graphJson(stages));
  EXPECT_EQ(json["options"]["find_rooms"]["min_width"], 2.25);
  const FieldTable table = describe(stages.options);
  std::size_t count = 0;
  for (const auto& section : json["options"]) count += section.size();
  EXPECT_EQ(count, table.fields().size());
  EXPECT_TRUE(json["options"]["keep_components"]["only_largest"].is_boolean());
  EXPECT_TRUE(json["options"]["thin_obstacles"]["neighbours"].is_string());
}

TEST(GraphJson, doesNotDependOnTheFolderOfTheMap) {
  Stages here = sampleStages(), there = sampleStages();
  there.source.file = "/another/" + std::string("two rooms.png");
  EXPECT_EQ(graphJson(here), graphJson(there));
}

TEST(GraphJson, writesCoordinatesInTenthsOfMillimetres) {
  Stages stages = sampleStages();
  stages.result.graph =
      TopologyGraph({{{-0.00001, 1.0 / 3}, 12345678.00006, VertexKind::junction, {}}}, {});
  stages.result.rooms.clear();
  const std::string text = graphJson(stages);
  EXPECT_NE(text.find("\"x\":0.0,\"y\":0.3333,\"clearance\":12345678.0001"), std::string::npos);
}

TEST(GraphJson, anUnboundedClearanceIsNull) {
  Stages stages = sampleStages();
  auto vertices = stages.result.graph.vertices();
  auto edges = stages.result.graph.edges();
  edges[0].path.minClearance = std::numeric_limits<double>::infinity();
  stages.result.graph = TopologyGraph(vertices, edges);
  const std::string text = graphJson(stages);
  EXPECT_TRUE(Json::parse(text)["edges"][0]["min_clearance"].is_null());
  EXPECT_EQ(schemaComplaint(text), "");
}

TEST(GraphJson, aFileNameThatIsNotUtf8StillGivesJson) {
  Stages stages = sampleStages();
  stages.source.file = "caf\xe9.png";
  EXPECT_EQ(schemaComplaint(graphJson(stages)), "");
}

}  // namespace
}  // namespace roomgraph
