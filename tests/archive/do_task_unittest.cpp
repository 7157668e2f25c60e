#include <gtest/gtest.h>

#include <filesystem>

#include "TestFolder.h"
#include "drawn_building.h"
#include "roomgraph/archive/FleetTask.h"
#include "roomgraph/archive/plan_fleet.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/graph_files/ros_map.h"

namespace roomgraph {
namespace {

/** Three maps of a building, and the task that they are planned as. */
struct TaskFleet {
  TestFolder folder;
  PlanFleetOptions options;
  FleetTask task;

  TaskFleet() {
    RunList listed;
    for (const char* name : {"a.pgm", "b.pgm", "c.pgm"}) {
      write(name, 1, {0, listed.size() * 2.0, 0.2 * double(listed.size())});
      listed.push_back({"office", {"", "anna", folder / name, 1000}});
    }
    const Archive archive(folder / "fleet.db", Archive::Access::orNew);
    task = planFleet(listed, archive, options).at(0);
  }
  void write(const std::string& name, std::uint32_t seed, const Transform2D& pose) const {
    folder.write(name, mapPgm(test::drawnBuilding(seed, pose)));
  }
  TaskResult run() const { return doTask(task, options.compare); }
};

TEST(DoTask, theRunsOfATaskAreCompared) {
  const TaskResult result = TaskFleet().run();
  EXPECT_EQ(result.comparison.runs.size(), 3u);
  EXPECT_TRUE(result.failures.empty());
}

TEST(DoTask, aMapThatIsGoneOrAnotherOneNowIsLeftOutAndNamed) {
  const TaskFleet fleet;
  fleet.write("b.pgm", 11, {});
  std::filesystem::remove(fleet.folder / "c.pgm");
  const TaskResult result = fleet.run();
  EXPECT_EQ(result.comparison.runs.size(), 1u);
  ASSERT_EQ(result.failures.size(), 2u);
  EXPECT_EQ(result.failures[0].rfind(fleet.folder / "c.pgm: ", 0), 0u) << result.failures[0];
  EXPECT_EQ(result.failures[1],
            fleet.folder / "b.pgm: is another map now than when it was planned");
}

TEST(DoTask, withoutAnyOfItsMapsItFails) {
  const TaskFleet fleet;
  for (const char* name : {"a.pgm", "b.pgm", "c.pgm"}) fleet.write(name, 11, {});
  EXPECT_THROW(fleet.run(), DataError);
}

TEST(DoTask, itIsDoneWithTheOptionsThatItWasPlannedWith) {
  TaskFleet fleet;
  fleet.options.compare.compare.scoreScale *= 2;
  EXPECT_THROW(fleet.run(), DataError);
}

}  // namespace
}  // namespace roomgraph
