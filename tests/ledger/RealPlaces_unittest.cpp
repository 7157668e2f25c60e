#include "RealPlaces.h"

#include <gtest/gtest.h>

#include "no_consensus.h"

namespace roomgraph::test {
namespace {

/** A run of 10 m with two scans, each of which has drawn the half in which it was taken. */
roomgraph::Run twoHalves() {
  roomgraph::Run run;
  run.map.frame = {100, 40, 0.1, {}};
  for (const double x : {2.0, 8.0}) {
    ScanWalls scan;
    scan.pose = {x, 2, 0};
    for (double along = -1.5; along <= 1.5; along += 0.1)
      scan.walls.push_back({{x + along, 3.5}, {0, -1}});
    run.scans.push_back(scan);
  }
  return run;
}

/** The second half lies 2 m further on than drawn. */
Consensus tornInHalf(const roomgraph::Run& run, const Transform2D& frame = {}) {
  Consensus consensus;
  consensus.graphRuns = {addRunNodes(run, consensus.graph)};
  consensus.siteRuns.add(0);
  consensus.errors.add({});
  consensus.poses.add(frame * run.scans[0].pose);
  consensus.poses.add(frame * Transform2D{2, 0, 0} * run.scans[1].pose);
  return consensus;
}

TEST(RealPlaces, areWhereTheScanReallyLiesThatHasDrawnThem) {
  const roomgraph::Run run = twoHalves();
  const Site site{{&run}, {{}}, {0}, {}};
  const RealPlaces places(site, tornInHalf(run), {}, 0);
  EXPECT_LT(distance(places.at({1, 0.2})({1, 0.2}), {1, 0.2}), 1e-9);
  EXPECT_LT(distance(places.at({9, 0.2})({9, 0.2}), {11, 0.2}), 1e-9);
  EXPECT_LT(distance(places.at({30, 2})({30, 2}), {32, 2}), 1e-9) << "beyond the map";
}

TEST(RealPlaces, ofARunWithoutScansAreThoseOfTheWhole) {
  roomgraph::Run run = twoHalves();
  run.scans.clear();
  const Site site{{&run}, {{5, -1, 0.3}}, {0}, {}};
  const RealPlaces places(site, noConsensus(site), {}, 0);
  EXPECT_LT(distance(places.at({9, 1})({9, 1}), site.poses[0]({9, 1})), 1e-9);
}

TEST(RealPlaces, ofACopyAreThoseOfTheRunThatCounts) {
  const roomgraph::Run run = twoHalves();
  const Site site{{&run, &run}, {{}, {}}, {0, 1}, {}};
  Consensus consensus = tornInHalf(run);
  consensus.graphRuns.push_back(consensus.graphRuns[0]);
  EXPECT_LT(distance(RealPlaces(site, consensus, {}, 1).at({9, 1})({9, 1}), {11, 1}), 1e-9);
}

TEST(RealPlaces, whatTheMostTrustedRunHasDrawnStaysInTheMean) {
  const roomgraph::Run run = twoHalves();
  const Site site{{&run}, {{5, -1, 0.3}}, {0}, {}};
  const Consensus consensus = tornInHalf(run, {-7, 3, 2});
  const Transform2D frame = frameOfConsensus(site, consensus, {1});
  const Point middle =
      0.5 * (frame(consensus.poses[NodeId(0)].shift()) + frame(consensus.poses[NodeId(1)].shift()));
  EXPECT_LT(distance(middle, site.poses[0]({5, 2})), 1e-9);
  EXPECT_LT(distance(frameOfConsensus({}, {}, {})({1, 2}), {1, 2}), 1e-9);
}

TEST(RealPlaces, ofRunsThatAreTrustedAlikeTheFrameIsThatOfTheOneWithTheLeastError) {
  const roomgraph::Run run = twoHalves();
  const Site site{{&run, &run}, {{9, 9, 0}, {}}, {0, 1}, {}};
  Consensus consensus = tornInHalf(run);
  consensus.graphRuns.push_back(addRunNodes(run, consensus.graph));
  consensus.siteRuns.add(1);
  for (const ScanWalls& scan : run.scans) consensus.poses.add(scan.pose);
  consensus.errors[RunId(0)].error = 1;
  consensus.errors.add({});
  EXPECT_LT(distance(frameOfConsensus(site, consensus, {0, 0})({1, 2}), {1, 2}), 1e-9);
  EXPECT_GT(distance(frameOfConsensus(site, consensus, {1, 0})({1, 2}), {1, 2}), 5);
}

}  // namespace
}  // namespace roomgraph::test
