#include "roomgraph/archive/SiteHistory.h"

#include <gtest/gtest.h>

#include "sample_nights.h"

namespace roomgraph {
namespace {

/** A night of three runs: the first is torn twice, the second once and once slightly. */
Comparison tornNight() {
  Comparison comparison = test::night("s", "anna", 1, 0.2, {"2", "3"}).comparison;
  for (const char* run : {"1", "1", "2"}) {
    comparison.breaks.emplace_back();
    comparison.breaks.back().run = run, comparison.breaks.back().shift = 0.5;
  }
  comparison.breaks.push_back(comparison.breaks.back());
  comparison.breaks.back().shift = 0.3;
  return comparison;
}

TEST(FiguresOf, areThoseOfTheScoreThenTheMeasures) {
  const Comparison comparison = tornNight();
  const ComparedRun& run = comparison.runs[0];
  const std::vector<Measure> figures = figuresOf(run, comparison);
  const Measure* error = find(figures, kMapError);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->value, 0.2);
  EXPECT_EQ(error->low, 0.1);
  EXPECT_EQ(error->high, 0.4);
  EXPECT_EQ(error->unit, "m");
  EXPECT_EQ(error->support, 1000);
  EXPECT_TRUE(error->isMeaningful);
  EXPECT_EQ(find(figures, kScore)->value, run.score->score);
  EXPECT_EQ(find(figures, "trust")->value, run.score->trust);
  EXPECT_EQ(find(figures, "shared_walls")->value, run.score->share);
  EXPECT_EQ(figures.back().name, "coverage");
}

TEST(FiguresOf, breaksThatAreNotSlightAreCountedRunByRun) {
  const Comparison comparison = tornNight();
  EXPECT_EQ(find(figuresOf(comparison.runs[0], comparison), kBreaks)->value, 2);
  EXPECT_EQ(find(figuresOf(comparison.runs[1], comparison), kBreaks)->value, 1);
  EXPECT_EQ(find(figuresOf(comparison.runs[2], comparison), kBreaks)->value, 0);
}

TEST(FiguresOf, aRunThatCannotBeJudgedHasFiguresThatDoNotCount) {
  const Comparison comparison = test::night("s", "anna", 1, 0.2, {}, false).comparison;
  const std::vector<Measure> figures = figuresOf(comparison.runs[0], comparison);
  EXPECT_FALSE(find(figures, kMapError)->isMeaningful);
  EXPECT_FALSE(find(figures, kBreaks)->isMeaningful);
}

TEST(FiguresOf, withoutAScoreThereAreMeasuresAlone) {
  Comparison comparison = tornNight();
  comparison.runs[0].score.reset();
  const std::vector<Measure> figures = figuresOf(comparison.runs[0], comparison);
  ASSERT_EQ(figures.size(), comparison.runs[0].measures.size());
  EXPECT_FALSE(find(figures, kBreaks)) << "it may be torn, for all that is known";
}

TEST(RoomsOf, areThoseThatTheRunWasAskedFor) {
  const Comparison comparison = tornNight();
  for (const ComparedRun& run : comparison.runs) {
    const std::vector<RoomSeen> rooms = roomsOf(run, comparison);
    ASSERT_EQ(rooms.size(), 3u);
    EXPECT_EQ(rooms[0].room, "R1");
    EXPECT_EQ(rooms[0].sighting, RoomSighting::seen);
    EXPECT_EQ(rooms[0].doors, 1);
    EXPECT_DOUBLE_EQ(rooms[0].area.value(), 16 * 1.01);
  }
  ComparedRun stranger;
  stranger.name = "9";
  EXPECT_TRUE(roomsOf(stranger, comparison).empty());
}

TEST(RoomsOf, doorsAreThoseThatTheRunHas) {
  Comparison comparison = test::night("s", "anna", 1, 0.2).comparison;
  comparison.rooms = {test::squareRoom("R1", {0, 0}, {"1"}, 2)};
  SiteRoom& room = comparison.rooms[0];
  const auto doors = [&] { return roomsOf(comparison.runs[0], comparison)[0].doors; };
  EXPECT_EQ(doors(), 2);
  room.runs[0].doorsGained = 1;
  EXPECT_EQ(doors(), 3) << "of its own";
  room.doors[0].seenIn = {"2", "3"};
  EXPECT_EQ(doors(), 2) << "one that others have";
}

TEST(RoomsOf, ofARoomThatIsNotMeasuredThereIsNoArea) {
  Comparison comparison = test::night("s", "anna", 1, 0.2).comparison;
  comparison.rooms[0].runs[0].areaChange.reset();
  comparison.rooms[0].runs[0].sighting = RoomSighting::gone;
  comparison.rooms[1].runs[0].isMerged = true;
  comparison.rooms[1].runs[0].pieces = 2;
  const std::vector<RoomSeen> rooms = roomsOf(comparison.runs[0], comparison);
  EXPECT_FALSE(rooms[0].area);
  EXPECT_EQ(rooms[0].sighting, RoomSighting::gone);
  EXPECT_TRUE(rooms[1].isMerged);
  EXPECT_EQ(rooms[1].pieces, 2);
}

TEST(TrustedFigure, isNoneWhereItCannotBeTrustedOrIsNotThere) {
  HistoryRun run = test::historyRun("anna", 1, 0.3);
  EXPECT_EQ(trustedValueOf(run.figures, kMapError), 0.3);
  EXPECT_FALSE(trustedValueOf(run.figures, kScore));
  run.figures[0].isMeaningful = false;
  EXPECT_FALSE(trustedValueOf(run.figures, kMapError));
  run.figures[0].isMeaningful = true;
  run.figures[0].value.reset();
  EXPECT_FALSE(trustedValueOf(run.figures, kMapError));
}

}  // namespace
}  // namespace roomgraph
