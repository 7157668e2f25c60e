#include "roomgraph/report/run_check_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "schemas.h"

namespace roomgraph {
namespace {

RunCheck sampleCheck() {
  RunCheck check;
  check.name = "a", check.file = "there/a.simplemap", check.sha256 = std::string(64, '0');
  check.selfError = 0.51234, check.low = 0.3, check.high = 0.7, check.seenTwice = 0.75;
  check.isConfirmed = true;
  MapBreak tear;
  tear.run = "a", tear.place = {1, 2}, tear.rotation = M_PI / 4, tear.shift = -0.5;
  tear.keyFrame = 17, tear.torn = TornPose{};
  check.breaks = {tear};
  check.doubled = {{{12, 30, 20, 5.5, {3, 4}}, {210, 228, 219, {}, {3, 4.8}}, 0.8, {}}};
  check.welded = {{{40, 45, 42, {}, {1, 1}}, {80, 86, 83, {}, {1, 1.5}}}};
  check.evidence = {{"beams_through_walls", "Walls", "1", 0.25, {}, 400}};
  check.path = {{0, std::nullopt, {}, {0.1, 0, 0}, 0.1, true},
                {17, 12.5, {1, 2, 0.5}, {}, 1, false}};
  check.sentence = "contradicts itself by 0.51 m";
  return check;
}

TEST(RunCheckJson, holdsWhatWasTold) {
  const auto json = nlohmann::json::parse(runCheckJson(sampleCheck()));
  EXPECT_EQ(json["file"], "a.simplemap");
  EXPECT_EQ(json["self_error_m"], 0.5123);
  EXPECT_EQ(json["seen_twice"], 0.75);
  EXPECT_EQ(json["confirmed"], true);
  EXPECT_EQ(json["breaks"][0]["key_frame"], 17);
  EXPECT_EQ(json["breaks"][0]["rotation_deg"], 45);
  EXPECT_TRUE(json["breaks"][0]["time"].is_null());
  const auto& passes = json["doubled"][0]["passes"];
  EXPECT_EQ(json["doubled"][0]["apart_m"], 0.8);
  EXPECT_EQ(passes[0]["first_key_frame"], 12);
  EXPECT_EQ(passes[0]["key_frame"], 20);
  EXPECT_EQ(passes[1]["last_key_frame"], 228);
  EXPECT_EQ(passes[1]["y"], 4.8);
  EXPECT_EQ(json["welded"][0]["passes"][1]["key_frame"], 83);
  EXPECT_EQ(json["evidence"][0]["name"], "beams_through_walls");
  EXPECT_EQ(json["evidence"][0]["drawn"], 0.25);
  EXPECT_TRUE(json["evidence"][0]["agreed"].is_null());
  EXPECT_EQ(json["path"][1]["time"], 12.5);
  EXPECT_EQ(json["path"].size(), 2u);
  const std::string sentence = json["sentence"];
  EXPECT_EQ("a: " + sentence + "\n", runCheckText(sampleCheck()));
}

TEST(RunCheckJson, whatCannotBeToldIsNull) {
  RunCheck check = sampleCheck();
  check.selfError.reset();
  const auto json = nlohmann::json::parse(runCheckJson(check));
  for (const char* name : {"self_error_m", "self_error_low_m", "self_error_high_m"})
    EXPECT_TRUE(json[name].is_null()) << name;
}

TEST(RunCheckJson, followsItsSchema) {
  RunCheck silent = sampleCheck();
  silent.selfError.reset(), silent.breaks.clear(), silent.path.clear();
  RunCheck unsized = sampleCheck();
  unsized.breaks.front().torn.reset();
  for (const RunCheck& check : {sampleCheck(), silent, unsized})
    EXPECT_EQ(test::schemaComplaint("check", runCheckJson(check)), "");
}

TEST(RunCheckText, isOneLineWithTheLargestBreak) {
  EXPECT_EQ(runCheckText(sampleCheck()),
            "a: 1 break, before key frame 17, "
            "45.0 degrees and -0.50 m; 1 place drawn twice, at (3.0, 4.0) by key frames 12 "
            "to 30 and, 0.80 m away, at (3.0, 4.8) by key frames 210 to 228; 1 place laid over "
            "another, at (1.0, 1.0) by key frames 40 to 45 and at (1.0, 1.5) by key "
            "frames 80 to 86; contradicts itself by 0.51 m\n");
}

TEST(RunCheckText, aBreakOfUnknownSizeIsCounted) {
  RunCheck check = sampleCheck();
  check.breaks.front().torn.reset(), check.doubled.clear(), check.welded.clear();
  EXPECT_EQ(runCheckText(check), "a: 1 break; contradicts itself by 0.51 m\n");
  EXPECT_EQ(selfBreakText(check.breaks.front()),
            "before key frame 17, by how much its scans do not tell");
}

}  // namespace
}  // namespace roomgraph
