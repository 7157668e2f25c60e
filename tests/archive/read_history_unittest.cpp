#include "read_history.h"

#include <gtest/gtest.h>

#include "Database.h"
#include "TestFolder.h"
#include "refusal.h"
#include "roomgraph/archive/Archive.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::night;

struct ReadHistory : testing::Test {
  const TestFolder folder;
  Archive archive{folder / "a.db", test::kOrNew};
};

TEST_F(ReadHistory, runsComeByTimeWhateverTheOrderInWhichTheyWereAdded) {
  for (const int n : {5, 1, 9, 3}) archive.record(night("office", "anna", n, 0.1));
  const SiteHistory history = archive.history("office");
  ASSERT_EQ(history.runs.size(), 4u);
  EXPECT_EQ(history.runs[0].sha256, "1");
  EXPECT_EQ(history.runs[1].sha256, "3");
  EXPECT_EQ(history.runs[2].sha256, "5");
  EXPECT_EQ(history.runs[3].sha256, "9");
}

TEST_F(ReadHistory, runsOfOneTimeComeAsTheyWereAdded) {
  for (const int n : {7, 2, 4}) {
    Addition addition = night("office", "anna", n, 0.1);
    addition.runs[0].time = 1000;
    archive.record(addition);
  }
  const SiteHistory history = archive.history("office");
  ASSERT_EQ(history.runs.size(), 3u);
  EXPECT_EQ(history.runs[0].sha256, "7");
  EXPECT_EQ(history.runs[2].sha256, "4");
}

TEST_F(ReadHistory, tablesThatContradictEachOtherAreDamagedAndTheNextSiteIsRead) {
  archive.record(night("office", "anna", 1, 0.1));
  archive.record(night("lab", "berta", 2, 0.4));
  Database database(folder / "a.db", false);
  database.run(
      "PRAGMA foreign_keys = OFF;"
      "UPDATE run SET comparison = 77 WHERE sha256 = '1'");
  const std::string text = test::refusalOf([&] { (void)archive.history("office"); });
  EXPECT_NE(text.find("is damaged"), std::string::npos) << text;
  EXPECT_EQ(archive.history("lab").runs.size(), 1u);
}

TEST_F(ReadHistory, eachSiteHasItsOwnRunsFiguresAndRooms) {
  archive.record(night("office", "anna", 1, 0.1));
  archive.record(night("lab", "berta", 2, 0.4));
  archive.record(night("office", "anna", 3, 0.2));
  const SiteHistory office = archive.history("office"), lab = archive.history("lab");
  ASSERT_EQ(office.runs.size(), 2u);
  ASSERT_EQ(lab.runs.size(), 1u);
  EXPECT_EQ(lab.runs[0].robot, "berta");
  EXPECT_EQ(trustedValueOf(lab.runs[0].figures, kMapError), 0.4);
  EXPECT_EQ(trustedValueOf(office.runs[1].figures, kMapError), 0.2);
  for (const HistoryRun& run : office.runs) EXPECT_EQ(run.rooms.size(), 3u);
  const SiteHistory none = archive.history("attic");
  EXPECT_EQ(none.site, "attic");
  EXPECT_TRUE(none.runs.empty());
  EXPECT_TRUE(none.ledger.rooms.empty());
}

TEST_F(ReadHistory, allOfARunComesBack) {
  Addition addition = night("office", "anna \"2\"", 1, 0.1);
  RoomInRun& gone = addition.comparison.rooms[1].runs[0];
  gone.sighting = RoomSighting::gone, gone.pieces = 0, gone.areaChange.reset();
  RoomInRun& hidden = addition.comparison.rooms[2].runs[0];
  hidden.sighting = RoomSighting::unvisited, hidden.isMerged = true, hidden.pieces = 3;
  hidden.shift = 0.25, hidden.boundaryAgreement = 0.5;
  archive.record(addition);
  const HistoryRun run = archive.history("office").runs[0];
  EXPECT_EQ(run.robot, "anna \"2\"");
  EXPECT_EQ(run.file, "1.simplemap");
  EXPECT_EQ(run.reason, "its walls lie where the others have them");
  ASSERT_EQ(run.rooms.size(), 3u);
  EXPECT_EQ(run.rooms[1].sighting, RoomSighting::gone);
  EXPECT_FALSE(run.rooms[1].area);
  EXPECT_FALSE(run.rooms[1].shift);
  EXPECT_EQ(run.rooms[2].sighting, RoomSighting::unvisited);
  EXPECT_TRUE(run.rooms[2].isMerged);
  EXPECT_EQ(run.rooms[2].pieces, 3);
  EXPECT_EQ(run.rooms[2].shift, 0.25);
  EXPECT_EQ(run.rooms[2].boundaryAgreement, 0.5);
  const Measure* error = find(run.figures, kMapError);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->low, 0.05);
  EXPECT_EQ(error->unit, "m");
  EXPECT_EQ(error->support, 1000);
}

TEST(SightingText, isAnotherForEach) {
  EXPECT_STREQ(nameOf(RoomSighting::seen), "seen");
  EXPECT_STREQ(nameOf(RoomSighting::gone), "gone");
  EXPECT_STREQ(nameOf(RoomSighting::unvisited), "unvisited");
}

}  // namespace
}  // namespace roomgraph
