#include "match_runs.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/consensus/PoseGraph.h"

namespace roomgraph {
namespace {

const Transform2D kOfSecond{3, -2, 0.4};

/** Two runs of one building, each in a frame of its own, and how they lie in each other. */
struct MatchedRuns {
  std::vector<roomgraph::Run> runs{2};
  Site site;
  MapPairs pairs{2};
  PoseGraph graph;

  MatchedRuns() {
    auto frames = test::drawnDrive(test::drawnBuilding(4, {}));
    const std::vector<Transform2D> poses{{}, kOfSecond};
    std::uint64_t scan = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[i].map = wallMap(test::drawnBuilding(4, poses[i]));
      for (Keyframe& frame : frames) frame.scanId = ++scan;  // of a log of its own
      runs[i].scans = scanWalls(test::moved(frames, poses[i]));
      site.runs.push_back(&runs[i]);
      site.poses.push_back(poses[i].inverse());
      addRunNodes(runs[i], graph);
    }
    follow(pairs(0, 1), runs[0].map, runs[1].map, {kOfSecond.inverse()});
  }
  MatchedRuns(const MatchedRuns&) = delete;

  std::vector<FoundGroup> matches() const {
    return matchRuns(site, pairs, graph, ById<RunId, std::size_t>(std::vector<std::size_t>{0, 1}),
                     oneByOne);
  }
};

TEST(MatchRuns, eachRunIsFoundInTheOther) {
  const MatchedRuns two;
  const auto matches = two.matches();
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].group.to, RunId(0));
  EXPECT_EQ(matches[0].group.from, RunId(1));
  EXPECT_EQ(matches[1].group.to, RunId(1));
  EXPECT_EQ(matches[1].group.from, RunId(0));
  for (const FoundGroup& found : matches)
    EXPECT_GT(double(found.matches.size()),
              0.9 * double(two.runs[found.group.to.index()].scans.size()));
}

TEST(MatchRuns, inABareMapItIsFoundAsInAFullOne) {
  MatchedRuns two;
  const auto full = two.matches();
  dropLookUp(two.runs[1].map);
  const auto bare = two.matches();
  ASSERT_EQ(bare.size(), full.size());
  for (std::size_t k = 0; k < full.size(); ++k) {
    ASSERT_EQ(bare[k].matches.size(), full[k].matches.size());
    for (std::size_t m = 0; m < full[k].matches.size(); ++m) {
      EXPECT_EQ(bare[k].matches[m].from, full[k].matches[m].from);
      EXPECT_EQ(bare[k].matches[m].share, full[k].matches[m].share);
    }
  }
}

TEST(MatchRuns, runsThatWereNotRelatedHaveNone) {
  MatchedRuns two;
  two.pairs = MapPairs(2, {});
  EXPECT_TRUE(two.matches().empty());
}

}  // namespace
}  // namespace roomgraph
