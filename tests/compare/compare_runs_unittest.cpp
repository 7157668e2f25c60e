#include "roomgraph/compare/compare_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "drawn_graph.h"
#include "map_files.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/compare/prepare_run.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/measures/measure_kinds.h"
#include "roomgraph/report/comparison_csv.h"
#include "roomgraph/report/comparison_json.h"
#include "schemas.h"

namespace roomgraph {
namespace {

using test::bent;
using test::drawnBuilding;

roomgraph::Run run(const std::string& name, const Grid& grid) {
  roomgraph::Run run;
  run.name = name, run.file = name + ".gridmap", run.sha256 = "hash of " + name;
  run.map = wallMap(grid);
  return run;
}

Comparison compared(const std::vector<roomgraph::Run>& runs,
                    const CompareRunsOptions& options = {}) {
  return compareRuns(runs, options);
}

std::vector<roomgraph::Run> threeGoodAndABentRun() {
  const Grid turnedMap = drawnBuilding(1, {3, -4, 0.4});
  return {run("c", drawnBuilding(1, {})), run("bent", bent(turnedMap, 0.08)),
          run("a", drawnBuilding(1, {-7, 2, 2.5})), run("b", drawnBuilding(1, {0, 1, -1.2}))};
}

template <typename RunOrPair>
const Measure& measureOf(const RunOrPair& of, const std::string& name) {
  return *find(of.measures, name);
}

TEST(CompareRuns, identicalRunsHaveScore100AndNoDistance) {
  const Grid map = drawnBuilding(2, {5, 6, 0.3});
  const Comparison result = compared({run("a", map), run("b", map)});
  ASSERT_EQ(result.runs.size(), 2u);
  for (const ComparedRun& one : result.runs) {
    ASSERT_TRUE(one.score);
    EXPECT_EQ(one.score->score, 100);
    EXPECT_EQ(measureOf(one, "bend").value, 0);
    EXPECT_EQ(one.score->mapError, 0);
    EXPECT_EQ(one.rank, 1u);
    EXPECT_FALSE(one.score->isMeaningful) << "two runs only";
    EXPECT_EQ(measureOf(one, "wall_distance_p90").value, 0);
    EXPECT_EQ(measureOf(one, "coverage").value, 1);
  }
  EXPECT_EQ(result.pairs[0].measures[0].value, 0);
}

TEST(CompareRuns, ofManyRunsACoreTellsWhichIsBent) {
  std::vector<roomgraph::Run> runs;
  for (int i = 0; i < 7; ++i)
    runs.push_back(
        run("run" + std::to_string(i), drawnBuilding(1, {double(i), 2.0 * i, 0.7 * i - 2})));
  runs[4] = run("bent", bent(drawnBuilding(1, {3, -4, 0.4}), 0.08));
  CompareRunsOptions options;
  options.core = 3;
  const Comparison some = compared(runs, options);
  EXPECT_EQ(some.core.size(), 3u);
  ASSERT_EQ(some.runs.size(), 7u);
  EXPECT_EQ(some.runs.back().name, "bent");
  for (const ComparedRun& one : some.runs) EXPECT_TRUE(one.score->isMeaningful) << one.name;
  EXPECT_NE(some.runs[0].reason.find("the core of 3 runs"), std::string::npos);
  std::reverse(runs.begin(), runs.end());
  EXPECT_EQ(comparisonJson(compared(runs, options)), comparisonJson(some))
      << "the order of the arguments counts";
  EXPECT_TRUE(compared(runs).core.empty());
}

TEST(CompareRuns, bareMapsChangeNothing) {
  std::vector<roomgraph::Run> runs = threeGoodAndABentRun();
  const std::vector<Keyframe> drive = test::drawnDrive(drawnBuilding(1, {}));
  for (const double turn : {0.3, 1.1}) {
    const auto frames = test::moved(drive, {2 * turn, 1, turn});
    runs.push_back(run("turned " + std::to_string(turn), test::mapDrawnBy(frames)));
    runs.back().scans = scanWalls(frames);
  }
  runs.push_back(runs.back());
  runs.back().name = "copy";
  for (const std::size_t core : {3u, 12u}) {
    CompareRunsOptions options;
    options.core = core;
    const std::string full = comparisonJson(compared(runs, options));
    std::vector<roomgraph::Run> bare = runs;
    for (roomgraph::Run& one : bare) dropLookUp(one.map);
    EXPECT_EQ(comparisonJson(compared(bare, options)), full) << core;
  }
}

TEST(CompareRuns, aCopyChangesNoCoverageAndNoMeaning) {
  const Grid half = drawnBuilding(1, {1, 2, 0.3}, {-1e9, 14});
  const std::vector<roomgraph::Run> two{run("half", half), run("whole", drawnBuilding(1, {}))};
  std::vector<roomgraph::Run> three = two;
  three.push_back(run("copy", drawnBuilding(1, {})));
  const Comparison before = compared(two), after = compared(three);
  ASSERT_EQ(after.runs.size(), 3u);
  for (const ComparedRun& one : after.runs) {
    EXPECT_FALSE(one.score->isMeaningful) << one.name;
    const std::size_t k = before.runs[0].name == (one.name == "copy" ? "whole" : one.name) ? 0 : 1;
    EXPECT_EQ(measureOf(one, "coverage").value, measureOf(before.runs[k], "coverage").value);
  }
}

TEST(CompareRuns, rangesHoldTheirValues) {
  for (const ComparedRun& one : compared(threeGoodAndABentRun()).runs)
    for (const Measure& measure : one.measures) {
      if (!measure.low) continue;
      EXPECT_LE(*measure.low, *measure.value) << one.name << ' ' << measure.name;
      EXPECT_GE(*measure.high, *measure.value) << one.name << ' ' << measure.name;
    }
}

TEST(CompareRuns, theBestRunThatHasSeenLittleIsSaidToHaveDoneSo) {
  const Comparison result = compared({run("a", drawnBuilding(1, {1, 2, 0.3}, {-1e9, 14})),
                                      run("b", bent(drawnBuilding(1, {}), 0.1)),
                                      run("c", bent(drawnBuilding(1, {}), 0.2))});
  ASSERT_EQ(result.runs[0].name, "a");
  EXPECT_NE(result.verdict.find("But a has seen"), std::string::npos) << result.verdict;
}

TEST(CompareRuns, aSecondSiteAmongTheRunsIsNamed) {
  const Comparison result =
      compared({run("a", drawnBuilding(1, {})), run("b", drawnBuilding(1, {1, 2, 0.3})),
                run("c", drawnBuilding(1, {4, 0, -0.2})), run("x", drawnBuilding(4, {})),
                run("y", drawnBuilding(4, {3, 1, 0.1}))});
  ASSERT_EQ(result.runs.size(), 3u);
  ASSERT_EQ(result.leftOut.size(), 2u);
  for (const LeftOutRun& one : result.leftOut)
    EXPECT_EQ(one.reason, "lies in another site: x and y");
  EXPECT_NE(result.verdict.find("There are 2 sites, of which this compares the first: "
                                "{a, b and c}, {x and y}."),
            std::string::npos)
      << result.verdict;
}

TEST(CompareRuns, runsOfOneDriveAreSaidToBeThat) {
  std::vector<roomgraph::Run> runs = threeGoodAndABentRun();
  for (const std::size_t i : {0u, 1u})
    for (std::uint64_t id = 1; id <= 9; ++id) {
      runs[i].scans.emplace_back();
      runs[i].scans.back().scanId = id;
      runs[i].scans.back().ends.add({1, 1});
    }
  ASSERT_EQ(runs[0].name + runs[1].name, "cbent");
  EXPECT_NE(compared(runs).verdict.find(" 2 runs are of one drive (bent and c)"), std::string::npos)
      << compared(runs).verdict;
}

TEST(CompareRuns, theMeasuresOfGraphsFollowThoseOfWalls) {
  std::vector<roomgraph::Run> runs = threeGoodAndABentRun();
  for (roomgraph::Run& one : runs) one.graph = test::drawnGraph();  // anywhere in the map
  const Comparison result = compared(runs);
  for (const ComparedRun& one : result.runs) {
    EXPECT_TRUE(measureOf(one, "path_coverage").value);
    EXPECT_TRUE(measureOf(one, "wall_doubling").value);
    EXPECT_TRUE(measureOf(one, "brokenness").value);
    EXPECT_TRUE(one.name == "bent" || measureOf(one, "brokenness").value == 0) << one.name;
  }
  for (const ComparedPair& pair : result.pairs) EXPECT_EQ(pair.measures.size(), 15u);
}

TEST(CompareRuns, aPairThatContradictsTheSiteIsFollowedAgain) {
  std::vector<roomgraph::Run> runs{run("a", drawnBuilding(1, {})),
                                   run("b", drawnBuilding(1, {0, 0, 0.01})),
                                   run("c", drawnBuilding(1, {0, 0, -0.01}))};
  for (roomgraph::Run& one : runs) one.graph = test::drawnGraph();
  MapPairs related = test::related(runs);
  const Transform2D halfTurn{20, 30, M_PI};
  related(0, 1).alignment.confidence = 0.1;
  for (FollowedWalls* walls : {&related(0, 1).bInA, &related(0, 1).aInB}) {
    walls->pose = halfTurn * walls->pose;
    for (FollowedPatch& patch : walls->patches) patch.pose = halfTurn * patch.pose;
  }
  const Comparison result = compareRuns(runs, related, {});
  for (const ComparedPair& pair : result.pairs)
    EXPECT_LT(measureOf(pair, "global_accuracy").value.value_or(99), 0.5) << pair.a << pair.b;
}

TEST(CompareRuns, aBentRunRanksLast) {
  const Comparison result = compared(threeGoodAndABentRun());
  ASSERT_EQ(result.runs.size(), 4u);
  EXPECT_EQ(result.runs[3].name, "bent");
  EXPECT_EQ(result.runs[3].rank, 4u);
  EXPECT_TRUE(result.runs[3].score->isMeaningful);
  EXPECT_GT(result.runs[2].score->low, result.runs[3].score->score);
  EXPECT_LT(result.runs[3].score->trust, 0.5 * result.runs[2].score->trust);
  EXPECT_EQ(result.verdict.rfind(result.runs[0].name + " is the best map", 0), 0u);
}

TEST(CompareRuns, figuresHaveTheDigitsThatFilesHold) {
  for (const ComparedRun& one : compared(threeGoodAndABentRun()).runs)
    for (const double figure : {one.score->mapError, one.score->errorHigh, one.score->score})
      EXPECT_EQ(figure, rounded(figure)) << one.name;
}

TEST(CompareRuns, theOrderOfTheRunsChangesNothing) {
  std::vector<roomgraph::Run> runs = threeGoodAndABentRun();
  const Comparison one = compared(runs);
  std::reverse(runs.begin(), runs.end());
  EXPECT_EQ(comparisonJson(one), comparisonJson(compared(runs)));
}

TEST(CompareRuns, aRunOfAnotherBuildingIsLeftOut) {
  const Comparison result =
      compared({run("a", drawnBuilding(1, {})), run("b", drawnBuilding(1, {2, 3, 1})),
                run("other", drawnBuilding(11, {}))});
  ASSERT_EQ(result.runs.size(), 2u);
  ASSERT_EQ(result.leftOut.size(), 1u);
  EXPECT_EQ(result.leftOut[0].name, "other");
  EXPECT_TRUE(result.leftOut[0].isOtherSite);
  EXPECT_EQ(result.pairs.size(), 3u);
}

TEST(CompareRuns, aRunThatLiesInOneOfTwoTurnsIsOfTheSite) {
  const std::vector<roomgraph::Run> runs{run("a", drawnBuilding(1, {})),
                                         run("b", drawnBuilding(1, {0, 0, 0.5}))};
  MapPairs related = test::related(runs);
  related(0, 1).alignment.confidence = 0.4, related(0, 1).alignment.runnerUpConfidence = 0.35;
  EXPECT_EQ(compareRuns(runs, related, {}).runs.size(), 2u);
  related(0, 1).alignment.runnerUpConfidence = 0.05;
  EXPECT_EQ(compareRuns(runs, related, {}).runs.size(), 1u) << "it may lie anywhere";
}

TEST(CompareRuns, aReferenceIsWhatAllAreMeasuredAgainst) {
  CompareRunsOptions options;
  options.reference = 1;
  const Comparison result = compared(
      {run("a", bent(drawnBuilding(1, {}), 0.08)), run("b", drawnBuilding(1, {2, 3, 1}))}, options);
  EXPECT_EQ(result.reference, "b");
  ASSERT_EQ(result.runs.size(), 2u);
  EXPECT_EQ(result.runs[0].name, "a");
  EXPECT_TRUE(result.runs[0].score->isMeaningful);
  EXPECT_LT(result.runs[0].score->score, 99);
  EXPECT_FALSE(result.runs[1].score);
  EXPECT_EQ(result.runs[1].pose.phi, 0);
}

TEST(CompareRuns, nothingToCompareIsSaid) {
  EXPECT_TRUE(compared({}).runs.empty());
  const Comparison one = compared({run("a", drawnBuilding(1, {}))});
  ASSERT_EQ(one.runs.size(), 1u);
  EXPECT_FALSE(one.runs[0].score);
  EXPECT_NE(one.verdict.find("nothing can be compared"), std::string::npos);
}

TEST(CompareRuns, refusesAWrongNumberOfPairs) {
  EXPECT_THROW(compareRuns(threeGoodAndABentRun(), MapPairs(), {}), UsageError);
  CompareRunsOptions options;
  options.reference = 3;
  EXPECT_THROW(compareRuns({}, options), UsageError);
}

std::string schemaComplaint(const std::string& text) {
  return test::schemaComplaint("comparison", text);
}

TEST(ComparisonJson, followsTheSchema) {
  Comparison result =
      compared({run("a", drawnBuilding(1, {})), run("b", drawnBuilding(1, {2, 3, 1})),
                run("other", drawnBuilding(11, {}))});
  result.runs[0].path = {{0, 1.5e9, {1, 2, 3}, 0.5}, {1, {}, {1, 3, 3}, {}}};
  result.breaks = {{"a", {1, 2}, 0.1, 0.5, 1, 1.5e9, TornPose{{1, 2, 0.3}, {1, 2.5, 0.2}}},
                   {"b", {1, 2}, 0.1, 0.5, {}, {}, {}}};
  const std::string good = comparisonJson(result);
  EXPECT_EQ(schemaComplaint(good), "");
  EXPECT_EQ(schemaComplaint(comparisonJson({})), "");
  for (const std::string name :
       {"runs", "pairs", "rooms", "breaks", "verdict", "map_error_low", "same_site", "runner_up",
        "meaningful", "path", "error_m", "pose_drawn", "pose_untorn", "files"}) {
    std::string broken = good;
    broken.replace(broken.find("\"" + name + "\""), name.size() + 2, "\"x\"");
    EXPECT_NE(schemaComplaint(broken), "") << name;
  }
}

TEST(CompareRuns, eachRunHasTheMeasuresOfTheTable) {
  for (const ComparedRun& one : compared(threeGoodAndABentRun()).runs) {
    ASSERT_EQ(one.measures.size(), runMeasureKinds().size());
    for (std::size_t i = 0; i < one.measures.size(); ++i)
      EXPECT_EQ(one.measures[i].name, runMeasureKinds()[i].name);
  }
}

TEST(ComparisonJson, theTableHasALineForEachRun) {
  const std::string csv = comparisonRunsCsv(compared(threeGoodAndABentRun()));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  const std::size_t columns =
      std::size_t(std::count(csv.begin(), csv.begin() + long(csv.find('\n')), ','));
  EXPECT_EQ(std::size_t(std::count(csv.begin(), csv.end(), ',')), 5 * columns);
}

TEST(CompareRuns, aPieceOfASymmetricBuildingHasToBeNeeded) {
  std::vector<roomgraph::Run> runs;
  for (const char* name : {"run04", "run08", "run09"}) {
    const std::string file =
        test::sharedFile(std::string("sim_runs/office_e/") + name + ".simplemap.gz");
    if (file.empty()) GTEST_SKIP() << "the simulated runs of office_e are not here";
    runs.push_back(prepareRun(name, loadGrid(file, {}), {}, {}));
  }
  const Comparison result = compared(runs);
  const ComparedRun* sound = findRun(result.runs, "run04");
  ASSERT_NE(sound, nullptr);
  EXPECT_LT(sound->score->mapError, 0.5) << "0.24 m by the true poses";
}

}  // namespace
}  // namespace roomgraph
