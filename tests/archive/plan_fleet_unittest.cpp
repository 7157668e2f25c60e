#include "roomgraph/archive/plan_fleet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "TestFolder.h"

namespace roomgraph {
namespace {

/** A picture of a map that no other has: so many cells wide. */
std::string picture(int width) {
  std::string text = "P2 " + std::to_string(width) + " 1 255\n";
  for (int i = 0; i < width; ++i) text += "254 ";
  return text + "\n";
}

/** An empty archive, and maps in a folder. */
struct Fleet {
  TestFolder folder;
  Archive archive{folder / "fleet.db", Archive::Access::orNew};
  RunList listed;
  std::vector<std::string> complaints;

  void add(const std::string& site, const std::string& name, int width) {
    listed.push_back({site, {"", "anna", folder.write(name, picture(width)), 1000.0 + width}});
  }
  std::vector<FleetTask> plan() {
    PlanFleetOptions options;
    options.onUnread = [&](const std::string& line) { complaints.push_back(line); };
    options.onMissing = [](const HistoryRun&) {};
    return planFleet(listed, archive, options);
  }
};

TEST(PlanFleet, eachSiteWithNewRunsIsATask) {
  Fleet fleet;
  fleet.add("office", "a.pgm", 3), fleet.add("lab", "b.pgm", 4), fleet.add("office", "c.pgm", 5);
  const auto tasks = fleet.plan();
  ASSERT_EQ(tasks.size(), 2u);
  EXPECT_EQ(tasks[0].site, "lab");
  EXPECT_EQ(tasks[1].site, "office");
  EXPECT_EQ(tasks[1].newRuns, 2u);
  ASSERT_EQ(tasks[1].runs.size(), 2u);
  for (const HistoryRun& run : tasks[1].runs) {
    EXPECT_EQ(run.sha256.size(), 64u);
    EXPECT_EQ(run.robot, "anna");
    EXPECT_GT(run.time, 1000);
  }
}

TEST(PlanFleet, aMapThatIsListedTwiceIsOneRun) {
  Fleet fleet;
  fleet.add("office", "a.pgm", 3), fleet.add("office", "b.pgm", 3);
  const auto tasks = fleet.plan();
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_EQ(tasks[0].newRuns, 1u);
}

TEST(PlanFleet, aFileThatIsNotThereIsToldAndTheRestPlanned) {
  Fleet fleet;
  fleet.add("office", "a.pgm", 3);
  fleet.listed.push_back({"office", {"", "anna", fleet.folder / "none.pgm", 1.0}});
  const auto tasks = fleet.plan();
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_EQ(tasks[0].runs.size(), 1u);
  ASSERT_EQ(fleet.complaints.size(), 1u);
  EXPECT_NE(fleet.complaints[0].find("none.pgm: "), std::string::npos) << fleet.complaints[0];
  EXPECT_EQ(fleet.complaints[0].find('\n'), std::string::npos);
}

TEST(PlanFleet, theOrderOfTheListChangesNothing) {
  Fleet fleet;
  for (int i = 0; i < 5; ++i)
    fleet.add(i % 2 ? "lab" : "office", "m" + std::to_string(i) + ".pgm", 3 + i);
  const auto before = fleet.plan();
  std::reverse(fleet.listed.begin(), fleet.listed.end());
  const auto after = fleet.plan();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].key, after[i].key);
    EXPECT_EQ(before[i].site, after[i].site);
  }
}

TEST(PlanFleet, ofAnEmptyListThereIsNoTask) {
  Fleet fleet;
  EXPECT_TRUE(fleet.plan().empty());
}

FleetTask someTask() {
  FleetTask task;
  task.site = "office", task.newRuns = 1;
  task.runs = {{"s1", "anna", "/maps/a", 1}, {"s2", "berta", "/maps/b", 2}};
  return task;
}

TEST(KeyOf, isOfTheSiteItsMapsAndTheOptions) {
  const CompareMapsOptions options;
  const std::string key = keyOf(someTask(), options);
  EXPECT_EQ(key.size(), 64u);
  const std::vector<std::function<void(FleetTask&)>> changes{
      [](FleetTask& task) { task.site = "lab"; },
      [](FleetTask& task) { task.runs[0].sha256 = "s3"; },
      [](FleetTask& task) { task.runs[1].file = "/maps/c"; },
      [](FleetTask& task) { task.runs.pop_back(); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    FleetTask other = someTask();
    changes[i](other);
    EXPECT_NE(keyOf(other, options), key) << i;
  }
  CompareMapsOptions scaled;
  scaled.estimatesScale = true;
  EXPECT_NE(keyOf(someTask(), scaled), key);
}

TEST(KeyOf, isNotOfWhatChangesNoResult) {
  const CompareMapsOptions options;
  const std::string key = keyOf(someTask(), options);
  FleetTask other = someTask();
  std::swap(other.runs[0], other.runs[1]);
  other.runs[0].robot = "carl", other.runs[1].time = 99;
  other.key = "anything", other.newRuns = 2;
  EXPECT_EQ(keyOf(other, options), key);
}

}  // namespace
}  // namespace roomgraph
