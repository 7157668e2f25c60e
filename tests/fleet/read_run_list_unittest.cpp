#include "roomgraph/fleet/read_run_list.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(ReadRunList, namesItsColumnsInAnyOrder) {
  const auto runs = readRunList(
      "file,note,site,time,robot\r\na.simplemap,x,office,2026-11-22,anna\n\n"
      "\"b, \"\"2\"\".yaml\",,lab,,\n/maps/c.yaml,,lab\n",
      "list.csv", "/data");
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].site, "office");
  EXPECT_EQ(runs[0].file, "/data/a.simplemap");
  EXPECT_EQ(runs[0].robot, "anna");
  EXPECT_EQ(runs[0].time, 1795305600);
  EXPECT_EQ(runs[1].file, "/data/b, \"2\".yaml");
  EXPECT_EQ(runs[1].robot, "robot");
  EXPECT_FALSE(runs[1].time);
  EXPECT_EQ(runs[2].file, "/maps/c.yaml");
}

TEST(ReadRunList, whatIsMissingIsNamedWithItsLine) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      readRunList(text, "list.csv", "");
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint("").find("list.csv: has no columns"), std::string::npos);
  EXPECT_NE(complaint("site;file\n").find("has no columns"), std::string::npos);
  EXPECT_NE(complaint("site,file\na,b\nc\n").find("list.csv: line 3 has no site or no file"),
            std::string::npos);
  EXPECT_NE(complaint("site,file,time\na,b,soon\n").find("line 2: 'soon' is no time"),
            std::string::npos);
  EXPECT_EQ(complaint("site,file\n"), "");
  EXPECT_EQ(complaint("site,file\n\"open,b"),
            "list.csv: line 2 has no site or no file: fill it in, "
            "or take the line out");
}

}  // namespace
}  // namespace roomgraph
