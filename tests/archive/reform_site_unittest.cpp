#include "reform_site.h"

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::night;

/** A night whose run agrees with some others, while one lies elsewhere. */
Addition nightWithout(int n, const std::vector<std::string>& others, const std::string& leftOut) {
  Addition addition = night("office", "anna", n, 0.1, others);
  addition.comparison.leftOut = {{leftOut, leftOut + ".simplemap", "lies in another site", true}};
  return addition;
}

class ReformSite : public testing::Test {
 protected:
  std::vector<bool> placed() const {
    std::vector<bool> all;
    for (const HistoryRun& run : archive_.history("office").runs) all.push_back(run.isPlaced);
    return all;
  }
  const TestFolder folder_;
  Archive archive_{folder_ / "site.db", Archive::Access::orNew};
};

TEST_F(ReformSite, aWrongFirstMapLocksNobodyOut) {
  archive_.record(night("office", "anna", 1, 0.1, {}, false));
  archive_.record(nightWithout(2, {}, "1"));
  archive_.record(nightWithout(3, {"2"}, "1"));
  EXPECT_EQ(placed(), (std::vector<bool>{true, false, false}));
  archive_.record(nightWithout(4, {"2", "3"}, "1"));
  EXPECT_EQ(placed(), (std::vector<bool>{false, true, true, true}));
  const SiteHistory history = archive_.history("office");
  EXPECT_TRUE(history.runs[0].figures.empty());
  EXPECT_TRUE(history.runs[0].rooms.empty());
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_TRUE(trustedValueOf(history.runs[i].figures, kMapError)) << i;
    EXPECT_FALSE(history.runs[i].rooms.empty()) << i;
  }
}

TEST_F(ReformSite, fewerRunsThanTheSiteHasDoNotReplaceIt) {
  archive_.record(night("office", "anna", 1, 0.1));
  for (int n = 2; n < 6; ++n) archive_.record(night("office", "anna", n, 0.1, {"1"}));
  archive_.record(nightWithout(6, {}, "5"));
  archive_.record(nightWithout(7, {"6"}, "5"));
  archive_.record(nightWithout(8, {"6", "7"}, "5"));
  EXPECT_EQ(placed(), (std::vector<bool>{true, true, true, true, true, false, false, false}));
}

TEST_F(ReformSite, aRunThatLiesThereAfterAllIsPlaced) {
  archive_.record(night("office", "anna", 1, 0.1));
  archive_.record(nightWithout(2, {}, "1"));
  EXPECT_EQ(placed(), (std::vector<bool>{true, false}));
  archive_.record(night("office", "anna", 3, 0.1, {"1", "2"}));
  EXPECT_EQ(placed(), (std::vector<bool>{true, true, true}));
}

TEST_F(ReformSite, roomsOfABadFirstNightGiveWayToThoseOfThree) {
  Addition bad = night("office", "anna", 1, 0.1);
  bad.comparison.rooms = {test::squareRoom("R1", {500, 500}, {"1"})};
  archive_.record(bad);
  ASSERT_EQ(archive_.history("office").ledger.rooms.size(), 1U);
  EXPECT_NE(archive_.record(night("office", "anna", 2, 0.1, {"1"})).roomsFailed, "");
  EXPECT_EQ(archive_.record(night("office", "anna", 3, 0.1, {"1", "2"})).roomsFailed, "");
  EXPECT_EQ(archive_.history("office").ledger.rooms.size(), 3U);
}

}  // namespace
}  // namespace roomgraph
