#include "run_measures.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** A run that has seen a square of 10 m free, as far as `seen` is left of it [m]. */
roomgraph::Run square(double seen) {
  roomgraph::Run run;
  run.map.frame = {100, 100, 0.1, {}};
  run.map.states.assign(run.map.frame.cellCount(), State::unknown);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 10 * seen; ++x) run.map.states[run.map.frame.index({x, y})] = State::free;
  for (const Point corner : {Point{0, 0}, Point{10, 0}, Point{0, 10}, Point{10, 10}})
    run.map.walls.push_back({corner, {1, 0}});
  return run;
}

std::vector<MeasuredValue> coverage(const std::vector<roomgraph::Run>& runs,
                                    const std::vector<Transform2D>& poses, const PairBends& bends) {
  Site site;
  for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
  site.poses = poses;
  return coverageOf(site, bends);
}

TEST(RunMeasures, coverageIsTheShareOfWhatTwoHaveSeen) {
  const std::vector<roomgraph::Run> runs{square(10), square(10), square(5)};
  const auto measures = coverage(runs, {{}, {}, {}}, PairBends(3));
  EXPECT_NEAR(measures[0].value.value(), 1, 1e-9);
  EXPECT_NEAR(measures[2].value.value(), 0.5, 0.02);
  EXPECT_NEAR(measures[2].high.value(), 1, 0.02) << "without one of the others";
}

TEST(RunMeasures, copiesThatArePlacedApartAreNoOtherWitnesses) {
  // Run 1 is a copy of run 0, and lies where runs 2 and 3 have seen something that run 0 has not.
  const std::vector<roomgraph::Run> runs{square(10), square(10), square(10), square(10)};
  PairBends bends(4);
  bends(0, 1).areIdentical = true;
  const auto measures = coverage(runs, {{}, {5, 0, 0}, {5, 0, 0}, {5, 0, 0}}, bends);
  EXPECT_NEAR(measures[0].value.value(), 0.5, 0.02);
  for (const std::size_t i : {1, 2, 3}) EXPECT_NEAR(measures[i].value.value(), 1, 1e-9) << i;
  for (const MeasuredValue& measure : measures) {
    EXPECT_GE(measure.low.value(), 0);
    EXPECT_LE(measure.high.value(), 1);
    EXPECT_LE(measure.low.value(), measure.value.value());
    EXPECT_GE(measure.high.value(), measure.value.value());
  }
}

}  // namespace
}  // namespace roomgraph
