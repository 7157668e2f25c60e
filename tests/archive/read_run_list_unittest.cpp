#include <gtest/gtest.h>

#include <cmath>

#include "RandomNumbers.h"
#include "refusal.h"
#include "roomgraph/archive/plan_fleet.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

/** Throws what is told of the first bad line. */
void refuseLine(const std::string& line) { throw DataError(line); }

TEST(ReadRunList, namesItsColumnsInAnyOrder) {
  const auto runs = readRunList(
      "file,note,site,time,robot\r\na.simplemap,x,office,2026-11-22,anna\n\n"
      "\"b, \"\"2\"\".yaml\",,lab,,\n/maps/c.yaml,,lab\n",
      "list.csv", "/data", refuseLine);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].first, "office");
  EXPECT_EQ(runs[0].second.file, "/data/a.simplemap");
  EXPECT_EQ(runs[0].second.robot, "anna");
  EXPECT_EQ(runs[0].second.time, 1795305600);
  EXPECT_EQ(runs[1].second.file, "/data/b, \"2\".yaml");
  EXPECT_EQ(runs[1].second.robot, "robot");
  EXPECT_TRUE(std::isnan(runs[1].second.time));
  EXPECT_EQ(runs[2].second.file, "/maps/c.yaml");
}

TEST(ReadRunList, whatIsMissingIsNamedWithItsLine) {
  const auto complaint = [](const std::string& text) {
    return test::refusalOf([&] { readRunList(text, "list.csv", "", refuseLine); });
  };
  EXPECT_NE(complaint("").find("list.csv: has no columns"), std::string::npos);
  EXPECT_NE(complaint("site;file\n").find("has no columns 'site' and 'file': "), std::string::npos);
  EXPECT_NE(complaint("file,robot\n").find("has no column 'site': "), std::string::npos);
  EXPECT_NE(complaint("site\n").find("has no column 'file': "), std::string::npos);
  EXPECT_NE(complaint("site,file\na,b\nc\n").find("list.csv: line 3 has no site or no file"),
            std::string::npos);
  EXPECT_NE(complaint("site,file,time\na,b,soon\n").find("line 2: 'soon' is not a time"),
            std::string::npos);
  EXPECT_EQ(complaint("site,file,time\na,b,2999-01-01\n"),
            "list.csv: line 2: '2999-01-01' is still to come: give the time of the run");
  EXPECT_EQ(complaint("site,file\n\n").rfind("list.csv: lists no run", 0), 0u);
  EXPECT_EQ(complaint("site,file\n\"open,b"),
            "list.csv: has a quote not closed in line 2: close it, or take it out");
}

TEST(ReadRunList, aBadLineCostsItselfAlone) {
  std::vector<std::string> bad;
  const auto keep = [&](const std::string& line) { bad.push_back(line); };
  const auto runs = readRunList("site,file,time\na,b,soon\na,c,\n,d,\n", "list.csv", "/", keep);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].second.file, "/c");
  ASSERT_EQ(bad.size(), 2u);
  EXPECT_NE(bad[0].find("line 2: 'soon'"), std::string::npos);
  EXPECT_NE(bad[1].find("line 4 has no site"), std::string::npos);
}

TEST(ReadRunList, columnsMayHaveLargeLetters) {
  const auto runs =
      readRunList("Site,FILE,Robot,Time\na,b,anna,2026-11-22\n", "list.csv", "/", refuseLine);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].second.robot, "anna");
  EXPECT_EQ(runs[0].second.time, 1795305600);
}

TEST(ReadRunList, takesWhatSpreadsheetsWrite) {
  const auto runs = readRunList("\xef\xbb\xbfsite,file\r\na,b\r\n", "list.csv", "/", refuseLine);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].first, "a");
}

TEST(ReadRunList, whateverStandsInItIsReadOrRefusedInOneLine) {
  test::RandomNumbers random(3);
  const std::string letters = "ab,\"\n\r ,,\"\"";
  std::size_t read = 0, refused = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    std::string text = "site,file\n";
    for (std::size_t i = random.below(30); i > 0; --i)
      text += letters[random.below(letters.size())];
    try {
      for (const auto& [site, run] : readRunList(text, "list.csv", "/data", refuseLine)) {
        EXPECT_FALSE(site.empty());
        EXPECT_EQ(run.file[0], '/');
      }
      ++read;
    } catch (const DataError& error) {
      const std::string line = error.what();
      EXPECT_TRUE(line.rfind("list.csv: li", 0) == 0 || line.rfind("list.csv: has ", 0) == 0)
          << line;
      ++refused;
    }
  }
  EXPECT_GT(read, 100u);
  EXPECT_GT(refused, 100u);
}

TEST(ReadRunList, aFileIsInTheFolderOfTheListUnlessItSaysOtherwise) {
  const auto fileOf = [](const std::string& file) {
    return readRunList("site,file\na," + file + "\n", "list.csv", "/data/night", refuseLine)[0]
        .second.file;
  };
  EXPECT_EQ(fileOf("m.yaml"), "/data/night/m.yaml");
  EXPECT_EQ(fileOf("../m.yaml"), "/data/m.yaml");
  EXPECT_EQ(fileOf("/maps/./m.yaml"), "/maps/m.yaml");
}

}  // namespace
}  // namespace roomgraph
