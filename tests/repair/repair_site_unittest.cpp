#include "roomgraph/repair/repair_site.h"

#include <gtest/gtest.h>

#include "repaired_site.h"
#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

const std::vector<roomgraph::Run>& runs() { return test::tornAmongSound().runs; }

TEST(RepairSite, runsAreMendedByEachOther) {
  const std::vector<RepairedRun> repaired = repairRuns(runs(), {});
  ASSERT_EQ(repaired.size(), 3u);
  EXPECT_EQ(repaired[0].state, RepairState::kept) << repaired[0].reason;
  EXPECT_EQ(repaired[1].state, RepairState::mended) << repaired[1].reason;
  EXPECT_GT(repaired[1].movedMost, 1);
}

TEST(RepairSite, oneRunThatSawNothingTwiceStaysAsItWas) {
  const std::vector<RepairedRun> repaired = repairRuns({runs()[0]}, {});
  ASSERT_EQ(repaired.size(), 1u);
  EXPECT_EQ(repaired[0].poses.size(), runs()[0].scans.size());
  EXPECT_EQ(repaired[0].state, RepairState::kept) << repaired[0].reason;
}

TEST(RepairSite, placesGoWithTheWallsRoundThem) {
  // The third run is the first one in another frame, but for what both drift.
  const Transform2D moved{5, -3, 1};
  const Transform2D place{runs()[0].scans[10].pose.x, runs()[0].scans[10].pose.y, 0.3};
  const std::vector<CarriedPlace> carried = carryPlaces({{"dock", place}}, runs(), 0, 2, {});
  ASSERT_EQ(carried.size(), 1u);
  EXPECT_EQ(carried[0].state, CarryState::carried) << carried[0].reason;
  ASSERT_TRUE(carried[0].pose);
  EXPECT_LT(distance(carried[0].pose->shift(), (moved * place).shift()), 0.1);
}

TEST(RepairSite, whatIsNotThereIsRefused) {
  CompareRunsOptions options;
  options.reference = 3;
  EXPECT_THROW((void)repairRuns(runs(), options), UsageError);
  EXPECT_THROW((void)carryPlaces({}, runs(), 0, 3, {}), UsageError);
  EXPECT_THROW((void)movedRun(runs()[0], repairRuns({runs()[0]}, {})[0]), DataError)
      << "it came from no file";
}

}  // namespace
}  // namespace roomgraph
