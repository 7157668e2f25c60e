#include "roomgraph/page/repair_page.h"

#include <gtest/gtest.h>

#include "occurrences.h"

namespace roomgraph {
namespace {

using test::has;

/** Three scans a metre apart, each of which has met one wall 2 m ahead of it. */
Run threeScans() {
  Run run;
  run.name = "a<b";
  run.scans.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    run.scans[k].keyFrame = 10 + k, run.scans[k].pose = {double(k), 0, 0};
    run.scans[k].walls = {{{double(k) + 2, 0.05}, {-1, 0}}};
  }
  return run;
}

/** The last of them was 3 m off. */
RepairedRun mended() {
  RepairedRun repaired;
  repaired.state = RepairState::mended;
  repaired.poses = {{}, {1, 0, 0}, {2, 3, 0}};
  repaired.moved = 1.7, repaired.movedMost = 3, repaired.movedMostAt = 12;
  repaired.unseen = {{11, 12}};
  return repaired;
}

std::string pageOf(const RepairedRun& repaired) {
  const Run run = threeScans();
  return repairPage({{&run, &repaired, "mended: why"}});
}

TEST(RepairPage, showsTheWallsBeforeAndAfter) {
  const std::string page = pageOf(mended());
  const std::size_t before = page.find("aria-label=\"before\"");
  ASSERT_NE(before, std::string::npos);
  EXPECT_LT(page.find("M40 -31h1"), before);  // 3 m up
  EXPECT_GT(page.find("M40 -1h1"), before);
  EXPECT_TRUE(has(page, "1 of 1 mended."));
}

TEST(RepairPage, tellsWhatMovedAndWhichStepsWereBreaks) {
  const std::string page = pageOf(mended());
  EXPECT_TRUE(has(page, "1.70 m RMS, up to 3.00 m at key frame 12"));
  EXPECT_TRUE(has(page, "before key frame 12, by 0.0 degrees and 3.00 m"));
  EXPECT_EQ(page.find("before key frame"), page.rfind("before key frame"));  // of no other step
  EXPECT_TRUE(has(page, "key frames 11 to 12<"));
  RepairedRun one = mended();
  one.unseen = {{11, 11}};
  EXPECT_TRUE(has(pageOf(one), ">key frame 11<"));
}

TEST(RepairPage, aRunThatIsLeftIsShownAsItWas) {
  RepairedRun kept;
  kept.poses = {{}, {1, 0, 0}, {2, 0, 0}};
  const std::string page = pageOf(kept);
  EXPECT_TRUE(has(page, "0 of 1 mended."));
  EXPECT_TRUE(has(page, "as it was"));
  EXPECT_FALSE(has(page, "class=\"before\""));
}

TEST(RepairPage, namesAreTextAndNothingElse) {
  const std::string page = pageOf(mended());
  EXPECT_TRUE(has(page, "<h2>a&lt;b</h2>"));
  EXPECT_FALSE(has(page, "a<b"));
}

}  // namespace
}  // namespace roomgraph
