#include "find_doubled.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** A way of ten scans, a metre each, and back again beside it, 20 key frames before them. */
class FindDoubled : public ::testing::Test {
 protected:
  FindDoubled() {
    for (std::size_t k = 0; k < 20; ++k) {
      const double x = k < 10 ? double(k) : 19 - double(k);
      run.scans.emplace_back();
      run.scans[k].keyFrame = 20 + k;
      run.scans[k].time = 100.0 + double(k);
      run.scans[k].pose = {x, 0, 0};
      consensus.poses.push_back({x, 0, 0});
    }
  }
  /** What the run has drawn from a scan on lies elsewhere. */
  void draw(std::size_t first, double beside) {
    for (std::size_t k = first; k < 20; ++k) run.scans[k].pose.y += beside;
  }
  void seeAgain(std::size_t from, std::size_t to, double off = 0) {
    const Transform2D found = consensus.poses[from].inverse() * consensus.poses[to];
    consensus.revisits.push_back(
        matchEdge(NodeId(from), NodeId(to), {found.x, found.y + off, found.phi}, 1));
  }
  std::vector<DoubledPlace> doubled(const std::vector<std::size_t>& broken = {}) const {
    return findDoubled(run, consensus, broken);
  }

  roomgraph::Run run;
  SelfConsensus consensus;
};

TEST_F(FindDoubled, tellsAPlaceByBothTimesThatItWasDrawn) {
  draw(12, 0.8);
  seeAgain(3, 16), seeAgain(14, 5);
  const auto places = doubled();
  ASSERT_EQ(places.size(), 1u);
  EXPECT_NEAR(places[0].apart, 0.8, 1e-9);
  EXPECT_EQ(places[0].one.first, 23u);
  EXPECT_EQ(places[0].one.last, 25u);
  EXPECT_EQ(places[0].other.first, 34u);
  EXPECT_EQ(places[0].other.last, 36u);
  EXPECT_EQ(places[0].one.time, 100.0 + double(places[0].one.keyFrame) - 20);
  EXPECT_NEAR(distance(places[0].one.place, places[0].other.place), 0.8, 1e-9);
  EXPECT_NEAR(places[0].mend.y, -0.8, 1e-9) << "of what the way back has drawn";
}

TEST_F(FindDoubled, whatLiesWhereItLayIsDrawnOnce) {
  seeAgain(3, 16), seeAgain(5, 14);
  EXPECT_TRUE(doubled().empty());
  draw(12, 0.3);
  EXPECT_TRUE(doubled().empty()) << "as much as a scan is off";
}

TEST_F(FindDoubled, whatABreakExplainsIsNotToldAgain) {
  draw(12, 0.8);
  seeAgain(3, 16), seeAgain(5, 14);
  EXPECT_TRUE(doubled({12}).empty());
  EXPECT_EQ(doubled({2}).size(), 1u) << "both lie behind that break";
}

TEST_F(FindDoubled, oneScanMayHaveSeenALookAlike) {
  draw(12, 0.8);
  seeAgain(3, 16);
  EXPECT_TRUE(doubled().empty());
}

TEST_F(FindDoubled, whereAsMuchDoesNotFitNothingIsTold) {
  draw(12, 0.8);
  seeAgain(3, 16), seeAgain(5, 14);
  seeAgain(4, 15, 2);
  EXPECT_TRUE(doubled().empty());
}

TEST_F(FindDoubled, placesFarFromEachOtherAreTwoTheWorstFirst) {
  draw(10, 0.8);
  for (std::size_t k = 0; k < 10; ++k) consensus.poses[19 - k].x *= 3, consensus.poses[k].x *= 3;
  for (std::size_t k = 0; k < 20; ++k) run.scans[k].pose.x *= 3;
  run.scans[18].pose.y += 1, run.scans[19].pose.y += 1;
  seeAgain(0, 19), seeAgain(1, 18);
  seeAgain(8, 11), seeAgain(7, 12);
  const auto places = doubled();
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR(places[0].apart, 1.8, 1e-9);
  EXPECT_NEAR(places[1].apart, 0.8, 1e-9);
}

TEST_F(FindDoubled, ofNothingThatWasSeenAgainNothingIsTold) {
  draw(12, 5);
  EXPECT_TRUE(doubled().empty());
}

}  // namespace
}  // namespace roomgraph
