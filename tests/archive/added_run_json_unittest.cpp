#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "roomgraph/archive/export_history.h"
#include "schemas.h"

namespace roomgraph {
namespace {

/** The line as a document that the schema accepts. */
nlohmann::json checked(const std::string& line) {
  EXPECT_EQ(test::schemaComplaint("watch", line), "") << line;
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto schema = nlohmann::json::parse(test::schemaText("watch"));
  const auto document = nlohmann::json::parse(line);
  for (const auto& member : document.items())
    EXPECT_TRUE(schema["properties"].contains(member.key())) << member.key();
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
  EXPECT_EQ(json["file"], "maps/a b.simplemap");
  EXPECT_TRUE(json["error"].is_null());
  EXPECT_EQ(json["map_error_m"], 0.25);
  EXPECT_TRUE(json["meaningful"].get<bool>() && json["placed"].get<bool>() &&
              json["alarm"].get<bool>());
  EXPECT_EQ(json["robot_says"], "its maps get worse");
  EXPECT_FALSE(json["may_roll_out"].get<bool>());
  EXPECT_EQ(json["advice"], "no, keep that of yesterday");
}

TEST(AddedRunJson, saysWhatIsNotKnown) {
  const auto json = checked(addedRunJson("a", {}, nullptr));
  EXPECT_TRUE(json["map_error_m"].is_null() && json["robot_says"].is_null());
  EXPECT_TRUE(json["may_roll_out"].is_null() && json["advice"].is_null());
  EXPECT_FALSE(json["alarm"].get<bool>() || json["placed"].get<bool>());
}

TEST(AddedRunJson, ofAFailureHasTheErrorAlone) {
  const auto json = checked(failedRunJson("caf\xe9.gridmap", "is damaged"));
  EXPECT_EQ(json["error"], "is damaged");
  EXPECT_FALSE(json.contains("placed"));
}

}  // namespace
}  // namespace roomgraph
