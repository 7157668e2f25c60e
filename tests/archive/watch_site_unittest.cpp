#include "roomgraph/archive/watch_site.h"

#include <gtest/gtest.h>

#include <functional>

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
  SiteRoom kitchen;
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
            "its latest maps are above the limit of 0.30 m; the last good one is of 1970-01-31");
  EXPECT_TRUE(watch.robots[1].errors.isAlarm());
}

/** Sound nights of anna, each as `change` leaves it. */
SiteHistory nights(int count, const std::function<void(HistoryRun&, int)>& change = nullptr) {
  SiteHistory history;
  for (int n = 0; n < count; ++n) {
    history.runs.push_back(historyRun("anna", n, 0.1));
    if (change) change(history.runs.back(), n);
  }
  return history;
}

RobotWatch annaIn(const SiteHistory& history) { return watchSite(history, {}).robots.at(0); }

TEST(WatchSite, aSoundMapMayBeRolledOut) {
  const RobotWatch anna = annaIn(nights(12));
  EXPECT_EQ(anna.rollout, Rollout::yes);
  EXPECT_EQ(anna.advice, "yes, the map of 1970-01-12 may be rolled out");
  EXPECT_FALSE(anna.isAlarm());
}

TEST(WatchSite, aBadLatestMapIsNotRolledOutAndTheLastGoodOneStays) {
  SiteHistory history = nights(12);
  history.runs.push_back(historyRun("anna", 12, 2.5));
  EXPECT_EQ(annaIn(history).rollout, Rollout::no);
  EXPECT_EQ(annaIn(history).advice,
            "no, the map of 1970-01-13 is 2.500 m off, with a limit of 0.3 m: keep that of "
            "1970-01-12");
  Measure breaks = history.runs.back().figures.front();
  breaks.name = kBreaks, breaks.value = 2;
  history.runs.back().figures.push_back(breaks);
  EXPECT_EQ(annaIn(history).advice,
            "no, the map of 1970-01-13 breaks in 2 places: keep that of 1970-01-12");
  EXPECT_FALSE(annaIn(history).isAlarm()) << "one bad night is no trend";
}

TEST(WatchSite, aMapWhoseWallsAreDrawnThickIsNotRolledOut) {
  SiteHistory history = nights(12);
  for (HistoryRun& run : history.runs)
    run.figures.push_back({"wall_sharpness", 1.0, "1", 1000, {}, {}, true});
  EXPECT_EQ(annaIn(history).rollout, Rollout::yes);
  history.runs.back().figures.back().value = 4;
  const RobotWatch watch = annaIn(history);
  EXPECT_EQ(watch.rollout, Rollout::no);
  EXPECT_NE(watch.advice.find("has walls that are too thick"), std::string::npos) << watch.advice;
}

TEST(WatchSite, ofAMapThatComesLateItTellsWhatWasKnownThen) {
  SiteHistory history = nights(12);
  for (HistoryRun& run : history.runs) run.sha256 = std::to_string(run.time);
  history.runs[6] = historyRun("anna", 6, 12);
  history.runs[6].sha256 = "late";
  EXPECT_EQ(annaIn(history).rollout, Rollout::yes);
  EXPECT_EQ(annaIn(historyUpTo(history, "late")).rollout, Rollout::no);
  EXPECT_EQ(historyUpTo(history, "none").runs.size(), 12U);
}

TEST(WatchSite, aMapThatLacksMuchOrShowsWhatIsNotThereIsNotRolledOut) {
  const auto adviceWith = [](const char* name, double value) {
    SiteHistory history = nights(12);
    Measure figure = history.runs.back().figures.front();
    figure.name = name, figure.value = value;
    history.runs.back().figures.push_back(figure);
    return annaIn(history).advice;
  };
  const std::string no = "no, the map of 1970-01-12 ", stays = ": keep that of 1970-01-11";
  EXPECT_EQ(adviceWith("coverage", 0.37), no + "shows only 37 % of the site" + stays);
  EXPECT_EQ(adviceWith("contradicted", 0.2),
            no + "has drawn 20 % that others contradict, and that fits nowhere else" + stays);
  EXPECT_EQ(adviceWith("confirmed", 0.6),
            no + "is confirmed by others in 60 % of what it has drawn, less than 70 %" + stays);
  EXPECT_EQ(adviceWith("confirmed", 0.75), "yes, the map of 1970-01-12 may be rolled out");
  EXPECT_EQ(adviceWith("walls_missing", 0.2),
            no + "lacks 20 % of the walls that others have" + stays);
  EXPECT_EQ(adviceWith("walls_added", 0.63),
            no + "has a place where 63 % of the walls stand in free space of the others" + stays);
  EXPECT_EQ(adviceWith("straight_walls_added", 0.04),
            no +
                "has a place where 4.0 % of the walls are straight and stand in free space of the "
                "others" +
                stays);
  EXPECT_EQ(adviceWith("coverage", 0.71), "yes, the map of 1970-01-12 may be rolled out");
}

TEST(WatchSite, ofTwoMapsOfOneDayTheTimesAreTold) {
  SiteHistory history = nights(12);
  history.runs.push_back(historyRun("anna", 11, 2.5));
  history.runs.back().time += 3600;
  EXPECT_EQ(annaIn(history).advice,
            "no, the map of 1970-01-12T01:00:00Z is 2.500 m off, with a limit of 0.3 m: keep that "
            "of 1970-01-12T00:00:00Z");
}

TEST(WatchSite, ofTwoMapsOfOneTimeAndNameTheFilesAreTold) {
  SiteHistory history = nights(12);
  history.runs.push_back(historyRun("anna", 11, 2.5));
  history.runs.back().file = "/new/map.simplemap", history.runs[11].file = "/old/map.simplemap";
  EXPECT_EQ(annaIn(history).advice,
            "no, the map of 1970-01-12T00:00:00Z (/new/map.simplemap) is 2.500 m off, with a limit "
            "of 0.3 m: keep that of 1970-01-12T00:00:00Z (/old/map.simplemap)");
}

TEST(WatchSite, mapsThatTellNothingOfTheSiteAreAnAlarmFromTheSecondNightOn) {
  SiteHistory history = nights(12);
  for (int n = 12; n < 14; ++n) {
    HistoryRun run = historyRun("anna", n, 0.1);
    run.isPlaced = false, run.figures.clear();
    history.runs.push_back(run);
    const RobotWatch anna = annaIn(history);
    EXPECT_EQ(anna.rollout, Rollout::no);
    EXPECT_EQ(anna.unjudged, std::size_t(n - 11));
    EXPECT_EQ(anna.isAlarm(), n == 13);
  }
  EXPECT_EQ(annaIn(history).sentence, "its last 2 maps tell nothing of the site");
  EXPECT_EQ(annaIn(history).advice,
            "no, the map of 1970-01-14 fits no other map of the site: keep that of 1970-01-12");
  history.runs.push_back(historyRun("anna", 14, 0.1));
  EXPECT_FALSE(annaIn(history).isAlarm());
}

TEST(WatchSite, theFirstNightsAreNotKnownYet) {
  SiteHistory history;
  for (int n = 0; n < 2; ++n) {
    history.runs.push_back(historyRun("anna", n, 0.1));
    history.runs.back().figures[0].isMeaningful = false;
    EXPECT_EQ(annaIn(history).rollout, Rollout::unknown);
    EXPECT_FALSE(annaIn(history).isAlarm());
  }
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
  const SiteHistory history = nights(20, [](HistoryRun& run, int n) {
    run.rooms = {seen("R1", 1, n < 10 ? 20 : 30), seen("R2", 1, 10)};
    if (n >= 12) run.rooms[1].sighting = RoomSighting::gone;
  });
  const SiteWatch watch = watchSite(history, {});
  ASSERT_EQ(watch.changes.size(), 2U);
  EXPECT_EQ(changeText(watch.changes[0], history),
            "R1: 30.0 m² instead of 20.0 m² since 1970-01-11");
  EXPECT_EQ(changeText(watch.changes[1], history), "R2: is gone since 1970-01-13");
}

TEST(WatchSite, theAreaOfACorridorIsNotAskedFor) {
  SiteHistory history =
      nights(20, [](HistoryRun& run, int n) { run.rooms = {seen("C1", 1, n < 10 ? 20 : 30)}; });
  EXPECT_EQ(watchSite(history, {}).changes.size(), 1U);
  SiteRoom corridor;
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
  SiteHistory history = nights(6);
  history.runs[5].figures.push_back(history.runs[5].figures[0]);
  history.runs[5].figures.back().name = kBreaks;
  history.runs[5].figures.back().value = 1;
  EXPECT_EQ(watchSite(history, {}).robots[0].lastGood, 4U);
}

TEST(WatchSite, anEmptyHistorySaysNothing) {
  const SiteWatch watch = watchSite({}, {});
  EXPECT_TRUE(watch.robots.empty());
  EXPECT_TRUE(watch.changes.empty());
}

std::string sentenceOf(const std::vector<double>& errors, const WatchOptions& options = {}) {
  const auto setError = [&](HistoryRun& run, int n) {
    run = historyRun("anna", n, errors[std::size_t(n)]);
  };
  return watchSite(nights(int(errors.size()), setError), options).robots.at(0).sentence;
}

TEST(WatchSite, aSentenceSaysWhatIsWrong) {
  EXPECT_EQ(sentenceOf({0.1, 0.1}), "too few nights to see a trend");
  EXPECT_EQ(sentenceOf(std::vector<double>(9, 0.1)), "too few nights to see a trend");
  EXPECT_EQ(sentenceOf(std::vector<double>(10, 0.1)), "its map is as good as ever");
  EXPECT_EQ(sentenceOf(std::vector<double>(40, 0.9)),
            "its latest maps are above the limit of 0.30 m; no good one is known");
  std::vector<double> rising, stepped;
  for (int n = 0; n < 40; ++n) {
    rising.push_back(0.05 + 0.004 * n + 0.002 * (n % 3));
    stepped.push_back((n < 25 ? 0.05 : 0.15) + 0.002 * (n % 3));
  }
  const std::string worse = sentenceOf(rising);
  EXPECT_EQ(worse.rfind("its map gets worse, by ", 0), 0u) << worse;
  EXPECT_NE(worse.find(" in 30 days; the limit is reached in "), std::string::npos) << worse;
  WatchOptions patient;
  patient.limit = 5;
  EXPECT_EQ(sentenceOf(std::vector<double>(40, 0.9), patient), "its map is as good as ever");
  const std::string changed = sentenceOf(stepped, patient);
  EXPECT_TRUE(changed.find("worse since 1970-01-26, by 0.10 m") != std::string::npos ||
              changed.find("gets worse") != std::string::npos)
      << changed;
}

TEST(WatchSite, eachRobotIsJudgedByItself) {
  SiteHistory both = sixtyNights(), alone;
  for (const HistoryRun& run : both.runs)
    if (run.robot == "berta") alone.runs.push_back(run);
  const RobotWatch withOther = watchSite(both, {}).robots[1],
                   byItself = watchSite(alone, {}).robots[0];
  EXPECT_EQ(withOther.sentence, byItself.sentence);
  EXPECT_EQ(withOther.runs.size(), byItself.runs.size());
  EXPECT_EQ(both.runs[*withOther.lastGood].time, alone.runs[*byItself.lastGood].time);
  EXPECT_EQ(both.runs[withOther.latest].time, alone.runs[byItself.latest].time);
}

TEST(WatchSite, fourRunsAreNotEnoughForAChange) {
  for (const int since : {15, 16}) {  // of twenty nights, so that five or four have the new door
    const SiteHistory history = nights(
        20, [&](HistoryRun& run, int n) { run.rooms = {seen("R1", n < since ? 2 : 3, 20)}; });
    EXPECT_EQ(watchSite(history, {}).changes.size(), since == 15 ? 1u : 0u) << since;
  }
}

TEST(WatchSite, whatIsDrawnALittleLargerIsNoChange) {
  const SiteHistory history =
      nights(20, [](HistoryRun& run, int n) { run.rooms = {seen("R1", 2, n < 10 ? 20 : 22)}; });
  EXPECT_TRUE(watchSite(history, {}).changes.empty());
}

TEST(WatchSite, aRoomThatSomeRunsDoNotVisitIsStillThere) {
  const SiteHistory history = nights(20, [](HistoryRun& run, int n) {
    run.rooms = {seen("R1", 2, 20)};
    if (n >= 8) run.rooms[0].sighting = RoomSighting::unvisited;
  });
  EXPECT_TRUE(watchSite(history, {}).changes.empty());
}

TEST(ChangeText, saysWhatIsThereAgainAndHowManyDoors) {
  SiteHistory history;
  history.runs.push_back(historyRun("anna", 3, 0.1));
  EXPECT_EQ(changeText({"R1", "seen", 0, 0, 1}, history), "R1: is there since 1970-01-04");
  EXPECT_EQ(changeText({"R1", "doors", 0, 2, 1}, history),
            "R1: 1 door instead of 2 since 1970-01-04");
  SiteRoom unnamed;
  unnamed.id = unnamed.name = "R1";
  history.ledger.rooms = {unnamed};
  EXPECT_EQ(changeText({"R1", "seen", 0, 1, 0}, history), "R1: is gone since 1970-01-04");
}

}  // namespace
}  // namespace roomgraph
