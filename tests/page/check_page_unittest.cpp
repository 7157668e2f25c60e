#include "roomgraph/page/check_page.h"

#include <gtest/gtest.h>

#include "occurrences.h"

namespace roomgraph {
namespace {

using test::has;

Run twoScans() {
  Run run;
  run.scans.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    run.scans[k].keyFrame = k, run.scans[k].pose = {double(k), 0, 0};
    run.scans[k].walls = {{{double(k) + 2, 1}, {0, -1}}};
  }
  run.map.walls = {{{2, 1}, {0, -1}}, {{3, 1}, {0, -1}}};
  return run;
}

RunCheck torn() {
  RunCheck check;
  check.name = "a<b", check.sentence = "agrees with itself within 0.50 m", check.selfError = 0.5;
  check.path = {{0, {}, {}, {}, 0, false}, {1, {}, {1, 0, 0}, {1, 0, 0}, 2, true}};
  MapBreak tear;
  tear.keyFrame = 1, tear.rotation = 0.5, tear.shift = 2;
  tear.torn = TornPose{{1, 0, 0}, {1, 5, 0}};
  check.breaks = {tear};
  return check;
}

TEST(CheckPage, showsEachBreakAsDrawnAndAsItFits) {
  const std::string page = checkPage(torn(), twoScans());
  EXPECT_TRUE(has(page, "Break 1: before key frame 1, 28.6 degrees and 2.00 m"));
  EXPECT_TRUE(has(page, "M3.00 -1.00h0"));  // the wall behind the break, as drawn
  EXPECT_TRUE(has(page, "M3.00 -6.00h0"));  // and 5 m farther, as it fits
  EXPECT_TRUE(has(page, "#b00020"));        // off by more than a metre
}

TEST(CheckPage, aBreakOfUnknownSizeIsShownAsDrawnAlone) {
  RunCheck check = torn();
  check.breaks.front().torn.reset();
  const std::string page = checkPage(check, twoScans());
  EXPECT_TRUE(has(page, "before key frame 1, by how much its scans do not tell"));
  EXPECT_TRUE(has(page, "as drawn"));
  EXPECT_FALSE(has(page, "as they fit"));
}

TEST(CheckPage, showsWhatIsDrawnTwiceAsDrawnAndAsItFits) {
  RunCheck check = torn();
  check.breaks.clear(), check.path[1].agreed = {1, 2, 0};
  check.doubled = {{{0, 0, 0, {}, {0, 0}}, {1, 1, 1, {}, {0, -2}}, 2, {0, 2, 0}}};
  const std::string page = checkPage(check, twoScans());
  EXPECT_TRUE(has(page, "Place 1: at (0.0, 0.0) by key frame 0 and, 2.00 m away"));
  EXPECT_TRUE(has(page, "M3.00 -3.00h0")) << "the later scan's wall, 2 m farther, as it fits";
  EXPECT_TRUE(has(page, "d=\"M0.00 -0.00L0.00 2.00\"")) << "from one place to the other on the map";
}

TEST(CheckPage, showsWhatLiesOverEachOther) {
  RunCheck check = torn();
  check.welded = {{{0, 0, 0, {}, {0, 0}}, {1, 1, 1, {}, {1, 0}}}};
  const std::string page = checkPage(check, twoScans());
  EXPECT_TRUE(has(page, "Laid over each other"));
  EXPECT_TRUE(has(page, "Place 1: at (0.0, 0.0) by key frame 0 and at (1.0, 0.0) by key"));
  EXPECT_FALSE(has(checkPage(torn(), twoScans()), "Laid over each other"));
}

TEST(CheckPage, hasATableOfTheEvidence) {
  RunCheck check = torn();
  check.evidence = {{"a", "A<B", "1", 0.25, 0.125, 40}, {"b", "C", "m", {}, {}, 0}};
  const std::string page = checkPage(check, twoScans());
  EXPECT_TRUE(has(page, "A&lt;B</th><td>25.0 %</td><td>12.5 %</td><td>40</td>"));
  EXPECT_TRUE(has(page, "C</th><td>-</td><td>-</td><td>0</td>"));
}

TEST(CheckPage, mapAndScansStandUpright) {
  auto askew = twoScans();
  askew.map.walls.clear();
  const Transform2D motion{0, 0, 0.3};
  for (int i = 0; i < 100; ++i)
    askew.map.walls.push_back({motion({0.1 * i, 0}), turned({0, 1}, 0.3)});
  askew.map.direction = 0.3;
  const std::string page = checkPage(torn(), askew);
  EXPECT_TRUE(has(page, "class=\"map\" aria-label=\"map\" role=\"img\" viewBox=\"-1.00 -1."))
      << "as wide as the wall is long, and not as its shadow";
  EXPECT_TRUE(has(page, "<g transform=\"rotate(17.19 0.00 -0.00)\">"));
  EXPECT_FALSE(has(page, "rotate(0.00"));
  EXPECT_FALSE(has(checkPage(torn(), twoScans()), "rotate(17"));
}

TEST(CheckPage, namesAreTextAndNothingElse) {
  const std::string page = checkPage(torn(), twoScans());
  EXPECT_TRUE(has(page, "<h1>a&lt;b: 1 break"));
  EXPECT_FALSE(has(page, "a<b"));
}

TEST(CheckPage, ofAGridOnlyTheMapAndItsFiguresAreShown) {
  RunCheck check;
  check.sentence = "cannot tell: it has no scans";
  check.evidence = {{"wall_doubling", "Walls drawn twice", "1", 0.25, {}, 40}};
  const std::string page = checkPage(check, {});
  EXPECT_TRUE(has(page, "cannot tell"));
  EXPECT_TRUE(has(page, "Walls drawn twice</th><td>25.0 %"));
  EXPECT_FALSE(has(page, "No break was found")) << "that would say too much";
}

}  // namespace
}  // namespace roomgraph
