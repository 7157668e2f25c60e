#include "roomgraph/mrpt_plugin/comparison_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mrpt_reads.h"
#include "roomgraph/align/wall_map.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

/** A room of 4 m, its lower left corner in the origin. */
Run makeRun(const std::string& name) {
  Run run;
  run.name = name, run.file = name + ".gridmap";
  run.map = wallMap(test::sampledGrid({80, 80, 0.05, {0, 0}}, [](Point p) {
    const bool isWall = std::min(p.x, p.y) < 0.2 || std::max(p.x, p.y) > 3.8;
    return isWall ? State::occupied : State::free;
  }));
  return run;
}

Comparison twoRuns() {
  Comparison result;
  result.runs.resize(2);
  result.runs[0].name = "a", result.runs[1].name = "b";
  result.runs[1].pose = {10, -3, 0.5};
  return result;
}

const std::vector<Run>& runs() {
  static const std::vector<Run> both = {makeRun("b"), makeRun("a")};
  return both;
}

TEST(ComparisonScene, eachRunIsALayerWithItsNameAndPose) {
  MrptScene scene = comparisonScene(twoRuns(), runs());
  const auto a = scene.getByName("run a"), b = scene.getByName("run b");
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(b->getPose().x, 10, 1e-9);
  EXPECT_NEAR(b->getPose().y, -3, 1e-9);
  EXPECT_NEAR(b->getPose().yaw, 0.5, 1e-9);
  EXPECT_GT(a->getPose().z, b->getPose().z) << "the best is on top";
}

TEST(ComparisonScene, aLayerHoldsTheWallsWhereTheyAre) {
  MrptScene scene = comparisonScene(twoRuns(), runs());
  const auto layer = std::dynamic_pointer_cast<viz::CSetOfObjects>(scene.getByName("run a"));
  const auto walls = std::dynamic_pointer_cast<viz::CPointCloud>(layer->getByName("walls"));
  ASSERT_TRUE(walls);
  EXPECT_GT(walls->size(), 100u);
  double low = HUGE_VAL, high = -HUGE_VAL;  // of x [m]
  for (std::size_t i = 0; i < walls->size(); ++i) {
    const double x = walls->getPose().x + double(walls->getPoint3Df(i).x);
    low = std::min(low, x), high = std::max(high, x);
  }
  EXPECT_NEAR(low, 0, 0.11);
  EXPECT_NEAR(high, 4, 0.11);
}

TEST(ComparisonScene, roomsAndBreaksAreThereWhereThereAreAny) {
  Comparison comparison = twoRuns();
  MrptScene without = comparisonScene(comparison, runs());
  for (const char* name : {"rooms", "room names", "breaks"}) EXPECT_FALSE(without.getByName(name));
  SiteRoom room;
  room.id = "R1", room.polygon.outer = {{0, 0}, {4, 0}, {4, 4}};
  comparison.rooms = {room};
  comparison.breaks = {{"b", {1, 2}, 0.1, 0.5, {}, {}}};
  MrptScene with = comparisonScene(comparison, runs());
  for (const char* name : {"rooms", "room names", "breaks", "legend"})
    EXPECT_TRUE(with.getByName(name)) << name;
}

/** The places of the texts of a set, by what they say. */
std::map<std::string, Point> textsIn(MrptScene& scene, const char* name) {
  const auto set = std::dynamic_pointer_cast<viz::CSetOfObjects>(scene.getByName(name));
  std::map<std::string, Point> texts;
  for (std::size_t i = 0; set && set->getByClass<viz::CText3D>(i); ++i) {
    const auto text = set->getByClass<viz::CText3D>(i);
    texts[text->getString()] = {text->getPose().x, text->getPose().y};
  }
  return texts;
}

TEST(ComparisonScene, namesRunsAndBreaks) {
  Comparison comparison = twoRuns();
  comparison.breaks = {{"b", {1, 2}, 0.1, 0.5, 7, {}, {}}};
  MrptScene scene = comparisonScene(comparison, runs());
  EXPECT_EQ(textsIn(scene, "legend").size(), 2u);
  EXPECT_EQ(textsIn(scene, "breaks").count("7"), 1u);
}

TEST(ComparisonScene, namesOfBreaksInOnePlaceDoNotLieOverEachOther) {
  Comparison comparison = twoRuns();
  for (std::size_t k : {7, 8, 9}) comparison.breaks.push_back({"b", {1, 2}, 0.1, 0.5, k, {}, {}});
  SiteRoom room;  // its name would lie in the second of them
  room.id = "R1", room.center = {0.6, 3}, room.polygon = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}};
  comparison.rooms = {room};
  MrptScene scene = comparisonScene(comparison, runs());
  auto texts = textsIn(scene, "breaks");
  texts.merge(textsIn(scene, "room names"));
  ASSERT_EQ(texts.size(), 4u);
  for (const auto& [words, place] : texts)
    for (const auto& [others, there] : texts) {
      if (words == others) continue;
      EXPECT_GT(std::abs(place.y - there.y), 0.35) << words << " " << others;
    }
}

TEST(ComparisonScene, aNameLiesInItsRoomAlsoWhereTheMiddleDoesNot) {
  Comparison comparison = twoRuns();
  SiteRoom ring;
  ring.id = ring.name = "C1", ring.center = {5, 5};
  ring.polygon = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{2, 2}, {2, 8}, {8, 8}, {8, 2}}}};
  comparison.rooms = {ring};
  MrptScene scene = comparisonScene(comparison, runs());
  const auto texts = textsIn(scene, "room names");
  ASSERT_EQ(texts.count("C1"), 1u);
  EXPECT_NE(sideOf(ring.polygon, texts.at("C1")), Side::outside);
}

TEST(ComparisonScene, aSlantedSiteStandsUprightAndItsNamesAreLevel) {
  Comparison comparison = twoRuns();
  comparison.runs[0].pose.phi = 0.3;
  SiteRoom room;
  room.id = "R1", room.center = {2, 2}, room.polygon = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {}};
  comparison.rooms = {room};
  MrptScene scene = comparisonScene(comparison, runs());
  const double azimuth = double(scene.getViewport()->getCamera().getAzimuthDegrees());
  EXPECT_NEAR(azimuth, -90 + 0.3 * 180 / M_PI, 0.5) << "the camera turns, not the site";
  const auto names = std::dynamic_pointer_cast<viz::CSetOfObjects>(scene.getByName("room names"));
  ASSERT_TRUE(names);
  EXPECT_NEAR((*names->begin())->getPose().yaw, 0.3, 0.01);
  const auto& walls = *scene.getByName("run a");
  EXPECT_NEAR(walls.getPose().yaw, 0.3, 1e-6) << "in the frame of the site";
}

TEST(ComparisonScene, isReadByMrpt) {
  MrptScene scene = test::sceneOf(comparisonSceneBytes(twoRuns(), runs()));
  EXPECT_TRUE(scene.getByName("run a"));
  EXPECT_TRUE(scene.getByName("run b"));
}

TEST(ComparisonScene, theSameRunsGiveTheSameBytes) {
  EXPECT_EQ(comparisonSceneBytes(twoRuns(), runs()), comparisonSceneBytes(twoRuns(), runs()));
}

TEST(ComparisonScene, aRunWithoutAMapIsNotDrawn) {
  MrptScene scene = comparisonScene(twoRuns(), {makeRun("a")});
  EXPECT_TRUE(scene.getByName("run a"));
  EXPECT_FALSE(scene.getByName("run b"));
  EXPECT_FALSE(comparisonSceneBytes({}, {}).empty());
}

}  // namespace
}  // namespace roomgraph
