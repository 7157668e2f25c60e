#include "roomgraph/archive/watch_site.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample_nights.h"

namespace roomgraph {
namespace {

using test::historyRun;

RoomSeen seen(const std::string& room, int doors, double area) {
  RoomSeen result;
  result.room = room, result.sighting = RoomSighting::seen, result.pieces = 1;
  result.doors = doors, result.area = area;
  return result;
}

/** Sixty nights of two robots; the odometry of one decays, and a door of R2 is walled up on night
 *  30. */
SiteHistory sixtyNights() {
  SiteHistory history;
  for (int n = 0; n < 60; ++n)
    for (const char* robot : {"anna", "berta"}) {
      const bool isBad = n > 20 && robot == std::string("berta");
      HistoryRun run = historyRun(robot, n, isBad ? 0.09 + 0.02 * (n - 20) : 0.1);
      run.rooms = {seen("R1", 2, 20), seen("R2", n < 30 ? 3 : 2, 12)};
      history.runs.push_back(run);
    }
  KnownRoom kitchen;
  kitchen.id = "R2", kitchen.name = "Kitchen";
  history.ledger.rooms = {kitchen};
  return history;
}

TEST(WatchSite, theRobotThatGetsWorseAlarmsAndTheOtherDoesNot) {
  const SiteHistory history = sixtyNights();
  const SiteWatch watch = watchSite(history, {});
  ASSERT_EQ(watch.robots.size(), 2U);
  EXPECT_EQ(watch.robots[0].robot, "anna");
  EXPECT_FALSE(watch.robots[0].errors.isAlarm());
  EXPECT_EQ(watch.robots[0].sentence, "its map is as good as ever");
  EXPECT_TRUE(watch.robots[1].errors.isOverLimit);
  ASSERT_TRUE(watch.robots[1].lastGood);
  EXPECT_EQ(history.runs[*watch.robots[1].lastGood].time, 30 * 86400);
  EXPECT_EQ(watch.robots[1].sentence,
            "its map is above the limit of 0.30 m; the last good one is of 1970-01-31");
  EXPECT_TRUE(watch.isAlarm());
}

TEST(WatchSite, aDoorThatIsWalledUpIsNamedWithItsNight) {
  const SiteHistory history = sixtyNights();
  const SiteWatch watch = watchSite(history, {});
  ASSERT_EQ(watch.changes.size(), 1U);
  EXPECT_EQ(history.runs[watch.changes[0].run].time, 30 * 86400);
  EXPECT_EQ(changeText(watch.changes[0], history),
            "R2 Kitchen: 2 doors instead of 3 since 1970-01-31");
}

TEST(WatchSite, roomsThatGoOrGrowAreTold) {
  SiteHistory history;
  for (int n = 0; n < 20; ++n) {
    HistoryRun run = historyRun("anna", n, 0.1);
    run.rooms = {seen("R1", 1, n < 10 ? 20 : 30), seen("R2", 1, 10)};
    if (n >= 12) run.rooms[1].sighting = RoomSighting::gone;
    history.runs.push_back(run);
  }
  const SiteWatch watch = watchSite(history, {});
  ASSERT_EQ(watch.changes.size(), 2U);
  EXPECT_EQ(changeText(watch.changes[0], history),
            "R1: 30.0 m² instead of 20.0 m² since 1970-01-11");
  EXPECT_EQ(changeText(watch.changes[1], history), "R2: is gone since 1970-01-13");
}

TEST(WatchSite, theAreaOfACorridorIsNotAskedFor) {
  SiteHistory history;
  for (int n = 0; n < 20; ++n) {
    HistoryRun run = historyRun("anna", n, 0.1);
    run.rooms = {seen("C1", 1, n < 10 ? 20 : 30)};
    history.runs.push_back(run);
  }
  EXPECT_EQ(watchSite(history, {}).changes.size(), 1U);
  KnownRoom corridor;
  corridor.id = "C1", corridor.isCorridor = true;
  history.ledger.rooms = {corridor};
  EXPECT_TRUE(watchSite(history, {}).changes.empty());
}

TEST(WatchSite, runsThatAreTornOrOfAnotherSiteSayNothingOfRooms) {
  SiteHistory history = sixtyNights();
  for (std::size_t i = 60; i < history.runs.size(); ++i) {
    if (i % 2 == 0)
      history.runs[i].isPlaced = false;
    else
      history.runs[i].figures.push_back(test::historyRun("x", 1, 1).figures[0]),
          history.runs[i].figures.back().name = kBreaks;
  }
  EXPECT_TRUE(watchSite(history, {}).changes.empty());
}

TEST(WatchSite, aTornMapIsNotTheLastGoodOne) {
  SiteHistory history;
  for (int n = 0; n < 6; ++n) history.runs.push_back(historyRun("anna", n, 0.1));
  history.runs[5].figures.push_back(history.runs[5].figures[0]);
  history.runs[5].figures.back().name = kBreaks;
  history.runs[5].figures.back().value = 1;
  EXPECT_EQ(watchSite(history, {}).robots[0].lastGood, 4U);
}

TEST(WatchSite, anEmptyHistorySaysNothing) {
  const SiteWatch watch = watchSite({}, {});
  EXPECT_TRUE(watch.robots.empty());
  EXPECT_TRUE(watch.changes.empty());
  EXPECT_FALSE(watch.isAlarm());
}

}  // namespace
}  // namespace roomgraph
