#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/schema.h>

#include <fstream>
#include <sstream>

#include "roomgraph/archive/export_history.h"

namespace roomgraph {
namespace {

std::string textOf(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/** The line as a document that the schema accepts. */
rapidjson::Document checked(const std::string& line) {
  rapidjson::Document schemaText, document;
  EXPECT_FALSE(schemaText.Parse(textOf(ROOMGRAPH_WATCH_SCHEMA).c_str()).HasParseError());
  EXPECT_FALSE(document.Parse(line.c_str()).HasParseError()) << line;
  const rapidjson::SchemaDocument schema(schemaText);
  rapidjson::SchemaValidator validator(schema);
  EXPECT_TRUE(document.Accept(validator)) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos);
  for (const auto& member : document.GetObject())
    EXPECT_TRUE(schemaText["properties"].HasMember(member.name)) << member.name.GetString();
  return document;
}

TEST(AddedRunJson, tellsTheFiguresAndTheAlarm) {
  AddedRun run;
  run.isPlaced = true, run.reason = "bends\nin \"R2\"";
  run.score = RunScore{};
  run.score->mapError = 0.25, run.score->isMeaningful = true;
  RobotWatch robot;
  robot.sentence = "its maps get worse", robot.errors.isOverLimit = true;
  robot.rollout = Rollout::no, robot.advice = "no, keep that of yesterday";
  const auto json = checked(addedRunJson("maps/a b.simplemap", run, &robot));
  EXPECT_STREQ(json["file"].GetString(), "maps/a b.simplemap");
  EXPECT_TRUE(json["error"].IsNull());
  EXPECT_EQ(json["map_error_m"].GetDouble(), 0.25);
  EXPECT_TRUE(json["meaningful"].GetBool() && json["placed"].GetBool() && json["alarm"].GetBool());
  EXPECT_STREQ(json["robot_says"].GetString(), "its maps get worse");
  EXPECT_FALSE(json["may_roll_out"].GetBool());
  EXPECT_STREQ(json["advice"].GetString(), "no, keep that of yesterday");
}

TEST(AddedRunJson, saysWhatIsNotKnown) {
  const auto json = checked(addedRunJson("a", {}, nullptr));
  EXPECT_TRUE(json["map_error_m"].IsNull() && json["robot_says"].IsNull());
  EXPECT_TRUE(json["may_roll_out"].IsNull() && json["advice"].IsNull());
  EXPECT_FALSE(json["alarm"].GetBool() || json["placed"].GetBool());
}

TEST(AddedRunJson, ofAFailureHasTheErrorAlone) {
  const auto json = checked(failedRunJson("caf\xe9.gridmap", "is damaged"));
  EXPECT_STREQ(json["error"].GetString(), "is damaged");
  EXPECT_FALSE(json.HasMember("placed"));
}

}  // namespace
}  // namespace roomgraph
