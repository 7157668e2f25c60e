#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "confirm_runs.h"
#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {
namespace {

/** Four runs of one drive, which lie where they are drawn and have found each other. */
class LostScans : public testing::Test {
 protected:
  LostScans() {
    const std::vector<Keyframe> drive = test::drawnDrive(test::drawnBuilding(4, {}));
    for (roomgraph::Run& run : runs) {
      run.map = wallMap(test::mapDrawnBy(drive));
      run.scans = scanWalls(drive);
      site.runs.push_back(&run);
      site.poses.emplace_back();
      const RunId id = addRunNodes(run, consensus.graph);
      consensus.errors.add({});
      consensus.errors[id].isSeen.assign(run.scans.size(), true);
      consensus.siteRuns.add(id.index());
      consensus.graphRuns.push_back(id);
    }
    consensus.poses = consensus.graph.ownPoses();
  }

  void unsee(std::size_t run, std::size_t first, std::size_t count) {
    const auto from = consensus.errors[RunId(run)].isSeen.begin() + std::ptrdiff_t(first);
    std::fill(from, from + std::ptrdiff_t(count), false);
  }

  void move(const Transform2D& motion) {
    for (const NodeId node : consensus.nodesOf(0))
      consensus.poses[node] = motion * consensus.poses[node];
  }

  std::vector<std::size_t> lostOf(std::size_t run) const {
    const std::vector<bool> isLost = lostScans(site, pairs, consensus)[RunId(run)];
    std::vector<std::size_t> scans;
    for (std::size_t k = 0; k < isLost.size(); ++k)
      if (isLost[k]) scans.push_back(k);
    return scans;
  }

  std::array<roomgraph::Run, 4> runs;
  Site site;
  MapPairs pairs = MapPairs(4);
  Consensus consensus;
};

using Scans = std::vector<std::size_t>;

TEST_F(LostScans, areThoseThatFitNowhereThoughThePlaceIsKnown) {
  EXPECT_EQ(lostOf(0), Scans{});
  unsee(0, 5, 4);
  EXPECT_EQ(lostOf(0), (Scans{5, 6, 7, 8}));
  EXPECT_EQ(lostOf(1), Scans{});
  unsee(0, runs[0].scans.size() - 3, 3);
  EXPECT_EQ(lostOf(0).size(), 7u) << "at the end, too";
}

TEST_F(LostScans, oneOrTwoAreStray) {
  unsee(0, 0, 2);
  unsee(0, 7, 2);
  EXPECT_EQ(lostOf(0), Scans{});
}

TEST_F(LostScans, whereNobodyElseHasBeenNoneIs) {
  unsee(0, 5, 4);
  move({0, 500, 0});
  EXPECT_EQ(lostOf(0), Scans{});
}

TEST_F(LostScans, theOthersKnowThePlaceWhereTheConsensusHasIt) {
  unsee(0, 5, 4);
  const Transform2D away{30, 500, 2};
  move(away);
  for (const std::size_t j : {1u, 2u, 3u}) consensus.errors[RunId(j)].pose = away;
  EXPECT_EQ(lostOf(0), (Scans{5, 6, 7, 8}));
}

TEST_F(LostScans, twoOthersThatKnowThePlaceAreTooFew) {
  unsee(0, 5, 4);
  pairs = MapPairs(4, {{0, 1}, {0, 3}, {1, 2}});
  EXPECT_EQ(lostOf(0), Scans{});
}

TEST_F(LostScans, copiesSayNothingOfEachOther) {
  unsee(0, 5, 4);
  consensus.graphRuns[1] = RunId(0);
  EXPECT_EQ(lostOf(0), Scans{});
  consensus.graphRuns = {RunId(0), RunId(1), RunId(2), RunId(2)};
  EXPECT_EQ(lostOf(0), Scans{}) << "two of the others are one";
}

TEST_F(LostScans, theReferenceHasNone) {
  unsee(0, 5, 4);
  consensus.graph.reference = RunId(0);
  EXPECT_EQ(lostOf(0), Scans{});
}

TEST_F(LostScans, blindScansAreNotLost) {
  unsee(0, 5, 4);
  runs[0].scans[6].walls.clear();
  EXPECT_EQ(lostOf(0), Scans{}) << "one before, two behind it";
}

}  // namespace
}  // namespace roomgraph
