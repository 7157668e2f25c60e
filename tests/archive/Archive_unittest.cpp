#include "roomgraph/archive/Archive.h"

#include <gtest/gtest.h>

#include <thread>

#include "Database.h"
#include "TestFolder.h"
#include "roomgraph/base/Error.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::night;

class ArchiveTest : public testing::Test {
 protected:
  std::string file() const { return folder_ / "site.db"; }
  /** All rows of all tables, as one text. */
  std::string dump() const {
    Database database(file(), false);
    std::string text;
    for (const char* table :
         {"site", "settings", "comparison", "run", "compared", "figure", "sighting"})
      text += std::to_string(database.number(std::string("SELECT count(*) FROM ") + table)) + " ";
    return text;
  }
  const TestFolder folder_;
};

TEST_F(ArchiveTest, aRoomKeepsTheNameThatItWasGiven) {
  Archive archive(file(), test::kOrNew);
  archive.record(night("office", "anna", 1, 0.2, {"7"}));
  const auto rooms = [&] { return archive.history("office").ledger.rooms; };
  ASSERT_FALSE(rooms().empty());
  const std::string id = rooms().front().id;
  archive.nameRoom("office", id, "Kitchen");
  archive.record(night("office", "anna", 2, 0.2, {"8"}));
  EXPECT_EQ(rooms().front().id, id);
  EXPECT_EQ(rooms().front().name, "Kitchen");
  EXPECT_THROW(archive.nameRoom("office", "R99", "Attic"), DataError);
  EXPECT_THROW(archive.nameRoom("lab", id, "Attic"), DataError);
}

TEST_F(ArchiveTest, whatIsRecordedComesBack) {
  {
    Archive archive(file(), test::kOrNew);
    EXPECT_EQ(archive.record(night("office", "anna", 1, 0.2, {"7"})).runs, 1U);
  }
  const Archive archive(file(), Archive::Access::existing);
  EXPECT_EQ(archive.sites(), std::vector<std::string>{"office"});
  const SiteHistory history = archive.history("office");
  ASSERT_EQ(history.runs.size(), 1U);
  const HistoryRun& run = history.runs.front();
  EXPECT_EQ(run.robot, "anna");
  EXPECT_EQ(run.sha256, "1");
  EXPECT_EQ(run.time, 86400);
  EXPECT_TRUE(run.isPlaced);
  EXPECT_EQ(trustedValueOf(run.figures, kMapError), 0.2);
  const Measure* coverage = find(run.figures, "coverage");
  ASSERT_TRUE(coverage);
  EXPECT_EQ(coverage->low, 0.8);
  ASSERT_EQ(run.rooms.size(), 3U);
  EXPECT_EQ(run.rooms[0].doors, 1);
  EXPECT_DOUBLE_EQ(run.rooms[0].area.value(), 16 * 1.01);
  EXPECT_EQ(history.ledger.rooms.size(), 3U);
}

TEST_F(ArchiveTest, whatIsKnownIsNotDoubled) {
  Archive archive(file(), test::kOrNew);
  archive.record(night("office", "anna", 1, 0.2));
  const std::string before = dump();
  EXPECT_EQ(archive.record(night("office", "berta", 1, 0.3)).runs, 0U);
  EXPECT_EQ(dump(), before);
  EXPECT_TRUE(archive.knows("office", "1"));
  EXPECT_FALSE(archive.knows("lab", "1"));
  EXPECT_EQ(archive.record(night("lab", "anna", 1, 0.2)).runs, 1U);
}

TEST_F(ArchiveTest, aRunGetsFiguresOnceTheyCanBeTrustedAndKeepsThem) {
  Archive archive(file(), test::kOrNew);
  archive.record(night("office", "anna", 1, 0.2, {}, false));
  EXPECT_FALSE(trustedValueOf(archive.history("office").runs[0].figures, kMapError));
  archive.record(night("office", "anna", 2, 0.3, {"1"}));
  EXPECT_EQ(trustedValueOf(archive.history("office").runs[0].figures, kMapError), 0.1);
  Addition third = night("office", "anna", 3, 0.3, {"1", "2"});
  third.comparison.runs[1].score->mapError = 9;
  archive.record(third);
  EXPECT_EQ(trustedValueOf(archive.history("office").runs[0].figures, kMapError), 0.1);
}

TEST_F(ArchiveTest, aRunOfAnotherSiteHasNoFiguresAndNoRooms) {
  Archive archive(file(), test::kOrNew);
  archive.record(night("office", "anna", 1, 0.2));
  Addition other = night("office", "anna", 2, 0.2, {"1"});
  other.comparison.runs.erase(other.comparison.runs.begin());
  other.comparison.leftOut = {{"2", "2.simplemap", "does not lie there", true}};
  EXPECT_EQ(archive.record(other).runs, 1U);
  // Of two runs that do not fit, the comparison may keep the new one: the site is the known one.
  Addition alone = night("office", "anna", 3, 0.2);
  alone.comparison.leftOut = {{"1", "1.simplemap", "does not lie there", true}};
  EXPECT_EQ(archive.record(alone).runs, 1U);
  const SiteHistory history = archive.history("office");
  ASSERT_EQ(history.runs.size(), 3U);
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_FALSE(history.runs[i].isPlaced);
    EXPECT_TRUE(history.runs[i].figures.empty());
    EXPECT_TRUE(history.runs[i].rooms.empty());
  }
  EXPECT_EQ(history.runs[1].reason, "does not lie there");
}

TEST_F(ArchiveTest, aMapThatCouldNotBeReadIsNoRun) {
  Archive archive(file(), test::kOrNew);
  Addition addition = night("office", "anna", 1, 0.2, {"9"});
  addition.comparison.runs.erase(addition.comparison.runs.begin());
  addition.comparison.leftOut = {{"1", "1.simplemap", "is damaged", false}};
  EXPECT_EQ(archive.record(addition).runs, 0U);
  EXPECT_TRUE(archive.sites().empty());
}

TEST_F(ArchiveTest, roomsThatCannotBeToldLeaveTheFigures) {
  Archive archive(file(), test::kOrNew);
  archive.record(night("office", "anna", 1, 0.2));
  Addition other = night("office", "anna", 2, 0.2, {"1"});
  // One long room instead of three squares lies nowhere in the known ones.
  other.comparison.rooms = {test::squareRoom("R1", {500, 500}, {"1", "2"})};
  const Added added = archive.record(other);
  EXPECT_EQ(added.runs, 1U);
  EXPECT_NE(added.roomsFailed.find("they stay as they were"), std::string::npos);
  const SiteHistory history = archive.history("office");
  EXPECT_EQ(history.ledger.rooms.size(), 3U);
  EXPECT_TRUE(history.runs[1].rooms.empty());
  EXPECT_EQ(trustedValueOf(history.runs[1].figures, kMapError), 0.2);
}

TEST_F(ArchiveTest, idsStayThroughHundredsOfNights) {
  Archive archive(file(), test::kOrNew);
  for (int n = 1; n <= 200; ++n) {
    const std::vector<std::string> others(n > 1 ? 1 : 0, std::to_string(n - 1));
    Addition addition = night("office", "anna", n, 0.2, others);
    // Each comparison numbers its rooms anew.
    std::swap(addition.comparison.rooms[0], addition.comparison.rooms[1]);
    addition.comparison.rooms[0].id = "R1", addition.comparison.rooms[1].id = "R2";
    archive.record(addition);
  }
  const SiteHistory history = archive.history("office");
  EXPECT_EQ(history.ledger.rooms.size(), 3U);
  for (const HistoryRun& run : history.runs) EXPECT_EQ(run.rooms.size(), 3U);
}

TEST_F(ArchiveTest, severalThreadsAddEachRunOnce) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      Archive archive(file(), test::kOrNew);
      for (int n = 1; n <= 20; ++n) archive.record(night("office", "anna", n, 0.2));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(Archive(file(), Archive::Access::existing).runs("office").size(), 20U);
}

TEST_F(ArchiveTest, anArchiveThatIsNotThereIsNotMadeByReading) {
  EXPECT_THROW(Archive(file(), Archive::Access::existing), DataError);
  EXPECT_FALSE(std::filesystem::exists(file()));
}

}  // namespace
}  // namespace roomgraph
