#include "roomgraph/archive/FleetTask.h"

#include <gtest/gtest.h>

#include "refusal.h"

namespace roomgraph {
namespace {

TEST(TaskLines, whatIsWrittenIsReadBack) {
  FleetTask task;
  task.site = "office \"A\"\n", task.key = std::string(64, 'a'), task.newRuns = 1;
  task.runs = {{"s1", "anna", "/maps/a.simplemap", 1795305600.25}, {"s2", "b", "c", -1}};
  const std::string text = taskLines({task, task});
  const auto tasks = parseTaskLines(text, "tasks.jsonl");
  ASSERT_EQ(tasks.size(), 2U);
  EXPECT_EQ(tasks[1].site, task.site);
  EXPECT_EQ(tasks[1].key, task.key);
  EXPECT_EQ(tasks[1].newRuns, 1U);
  ASSERT_EQ(tasks[1].runs.size(), 2U);
  EXPECT_EQ(tasks[1].runs[0].file, "/maps/a.simplemap");
  EXPECT_EQ(tasks[1].runs[0].time, 1795305600.25);
  EXPECT_EQ(taskLines(tasks), text);
  EXPECT_TRUE(parseTaskLines("", "tasks.jsonl").empty());
}

TEST(TaskLines, whatIsNoTaskIsNamedWithItsLine) {
  FleetTask task;
  task.key = std::string(64, '0'), task.runs = {{"s", "r", "f", 0}};
  const std::string good = taskLines({task});
  const std::string key = "\"key\":\"" + task.key;
  std::string outside = good;
  outside.replace(outside.find(key), key.size(), "\"key\":\"../../../etc");
  for (const std::string& bad :
       {std::string("{}"), std::string("x"), good.substr(0, 40), outside}) {
    const std::string text = test::refusalOf([&] { parseTaskLines(good + bad, "tasks.jsonl"); });
    EXPECT_EQ(text.rfind("tasks.jsonl: line 2 is not a task", 0), 0U) << bad;
  }
}

}  // namespace
}  // namespace roomgraph
