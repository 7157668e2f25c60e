#include "roomgraph/report/faults.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** A run whose scans are of every second key frame. */
RunCheck checkOf(std::size_t scans) {
  RunCheck check;
  check.name = "run";
  check.path.resize(scans);
  for (std::size_t k = 0; k < scans; ++k) check.path[k].keyFrame = 2 * k;
  return check;
}

TEST(FaultsOf, aBreakIsShownByTheScansOnBothSidesOfIt) {
  RunCheck check = checkOf(40);
  check.breaks = {{"run", {1, 2}, 0.2, 1, 30, {}, TornPose{{5, 0, 0}, {4, 0, 0}}}};
  const std::vector<Fault> faults = faultsOf(check);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name(), "break1");
  EXPECT_EQ(faults[0].earlier.from, 10u);
  EXPECT_EQ(faults[0].earlier.to, 28u);
  EXPECT_EQ(faults[0].later.from, 30u);
  EXPECT_EQ(faults[0].later.to, 48u);
  EXPECT_EQ(faults[0].mend->x, -1);
}

TEST(FaultsOf, thereMayBeFewerScansOnOneSide) {
  RunCheck check = checkOf(8);
  check.breaks = {{"run", {}, 0.2, 1, 5, {}, {}},
                  {"run", {}, 0.2, 1, 0, {}, {}},
                  {"run", {}, 0.2, 1, 15, {}, {}}};
  const std::vector<Fault> faults = faultsOf(check);
  EXPECT_EQ(faults[0].earlier.text(), "0 to 4");
  EXPECT_EQ(faults[0].later.text(), "6 to 14") << "the next one that has a scan";
  EXPECT_FALSE(faults[1].earlier.holds(0));
  EXPECT_FALSE(faults[2].later.holds(14)) << "it has no scan from there on";
}

TEST(FaultsOf, twoTimesAreShownByTheScansBesideThem) {
  RunCheck check = checkOf(40);
  check.doubled = {{{0, 20, 4, {}, {0, 0}}, {60, 78, 77, {}, {0, -2}}, 2, {0, 2, 0}}};
  check.welded = {{{0, 20, 4, {}, {7, 0}}, {60, 78, 70, {}, {7, 1}}}};
  const std::vector<Fault> faults = faultsOf(check);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].name(), "doubled1");
  EXPECT_EQ(faults[0].earlier.from, 0u);
  EXPECT_EQ(faults[0].earlier.to, 24u);
  EXPECT_TRUE(faults[0].later.holds(78)) << "the next one that has a scan, and the last";
  EXPECT_EQ(faults[0].mend->y, 2);
  EXPECT_EQ(faults[1].name(), "welded1");
  EXPECT_EQ(faults[1].place.x, 7);
  EXPECT_FALSE(faults[1].mend);
}

TEST(FaultsOf, aRunWithoutScansShowsNone) {
  Comparison comparison;
  comparison.runs.resize(1);
  comparison.runs[0].name = "grid";
  comparison.breaks = {{"grid", {1, 2}, 0.2, 1, {}, {}, {}}, {"grid", {3, 2}, 0.1, 1, {}, {}, {}}};
  const std::vector<Fault> faults = faultsOf(comparison);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[1].name(), "break2");
  EXPECT_FALSE(faults[0].earlier.holds(0) || faults[0].later.holds(0));
  EXPECT_EQ(faults[0].text, "everything after it is turned by 11.5 degrees, shifted by 1.00 m");
}

}  // namespace
}  // namespace roomgraph
