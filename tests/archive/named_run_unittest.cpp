#include <gtest/gtest.h>

#include <filesystem>

#include "refusal.h"
#include "roomgraph/archive/SiteHistory.h"

namespace roomgraph {
namespace {

std::vector<HistoryRun> runs() {
  std::vector<HistoryRun> runs(3);
  runs[0].file = "/a/map.simplemap", runs[0].sha256 = "0123456789abcdef";
  runs[1].file = "/b/map.simplemap", runs[1].sha256 = "fedcba9876543210";
  runs[2].file = "/b/other.yaml", runs[2].sha256 = "0123456789000000";
  return runs;
}

TEST(NamedRun, filesNamesAndHashesNameARun) {
  const std::vector<HistoryRun> all = runs();
  for (const char* name : {"/b/other.yaml", "other.yaml", "01234567890", "0123456789000000"})
    EXPECT_EQ(&namedRun(all, name, "site.db"), &all[2]) << name;
}

TEST(NamedRun, aPathFromHereNamesARun) {
  std::vector<HistoryRun> all = runs();
  all[1].file = (std::filesystem::current_path() / "b/map.simplemap").string();
  EXPECT_EQ(&namedRun(all, "b/map.simplemap", "site.db"), &all[1]);
  EXPECT_EQ(&namedRun(all, "./b/../b/map.simplemap", "site.db"), &all[1]);
}

TEST(NamedRun, whatNamesNoneOrSeveralIsRefused) {
  for (const char* name : {"map.simplemap", "01234567", "none.yaml", "fedcba9", ""}) {
    const std::string text = test::refusalOf([&] { namedRun(runs(), name, "site.db"); });
    EXPECT_EQ(text.rfind("site.db: has ", 0), 0u) << name << ": " << text;
  }
}

}  // namespace
}  // namespace roomgraph
