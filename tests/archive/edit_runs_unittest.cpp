#include <gtest/gtest.h>

#include "TestFolder.h"
#include "roomgraph/base/Error.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::night;

class EditRuns : public testing::Test {
 protected:
  EditRuns() {
    archive_.record(night("office", "anna", 1, 0.1));
    archive_.record(night("office", "berta", 2, 0.2, {"1"}));
    archive_.record(night("office", "anna", 3, 0.3, {"1", "2"}));
  }
  std::string runs() const {
    std::string text;
    for (const HistoryRun& run : archive_.runs("office")) text += run.robot + run.sha256 + " ";
    return text;
  }
  const TestFolder folder_;
  Archive archive_{folder_ / "site.db", Archive::Access::orNew};
};

TEST_F(EditRuns, aRunThatIsTakenOutCanBeAddedAgain) {
  archive_.removeRun("office", "2.simplemap");
  EXPECT_EQ(runs(), "anna1 anna3 ");
  EXPECT_FALSE(archive_.knows("office", "2"));
  EXPECT_EQ(trustedValueOf(archive_.history("office").runs[1].figures, kMapError), 0.3);
  EXPECT_EQ(archive_.record(night("office", "berta", 2, 0.2, {"1", "3"})).runs, 1U);
  EXPECT_EQ(runs(), "anna1 berta2 anna3 ");
}

TEST_F(EditRuns, whatNamesNoRunOrSeveralTakesNoneOut) {
  EXPECT_THROW(archive_.removeRun("office", "9.simplemap"), DataError);
  EXPECT_THROW(archive_.removeRun("office", "1"), DataError) << "too few digits";
  EXPECT_THROW(archive_.removeRun("lab", "1.simplemap"), DataError);
  Addition twin = night("office", "anna", 4, 0.1, {"1"});
  twin.runs[0].file = "folder/1.simplemap";
  archive_.record(twin);
  EXPECT_THROW(archive_.removeRun("office", "1.simplemap"), DataError);
  EXPECT_EQ(archive_.runs("office").size(), 4U);
  archive_.removeRun("office", "folder/1.simplemap");
  EXPECT_EQ(runs(), "anna1 berta2 anna3 ");
}

TEST_F(EditRuns, theRunsOfARobotGetItsNewName) {
  archive_.renameRobot("office", "berta", "anna");
  EXPECT_EQ(runs(), "anna1 anna2 anna3 ");
  EXPECT_THROW(archive_.renameRobot("office", "berta", "carla"), DataError);
  EXPECT_THROW(archive_.renameRobot("lab", "anna", "carla"), DataError);
}

}  // namespace
}  // namespace roomgraph
