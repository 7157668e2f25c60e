#include "match_runs.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

const Transform2D kThere{3, -2, 0.4};

/** Two runs of one building, each in a frame of its own, and how they lie in each other. */
struct TwoRuns {
  std::vector<roomgraph::Run> runs{2};
  Site site;
  MapPairs pairs{2};
  std::vector<RunSubmaps> submaps;

  TwoRuns() {
    auto frames = test::drawnDrive(test::drawnBuilding(4, {}));
    const std::vector<Transform2D> poses{{}, kThere};
    std::uint64_t scan = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[i].map = wallMap(test::drawnBuilding(4, poses[i]), {});
      for (Keyframe& frame : frames) frame.scanId = ++scan;  // of a log of its own
      runs[i].scans = scanWalls(test::moved(frames, poses[i]));
      site.runs.push_back(&runs[i]);
      site.poses.push_back(poses[i].inverse());
      submaps.push_back(runSubmaps(runs[i]));
    }
    follow(pairs(0, 1), runs[0].map, runs[1].map, {kThere.inverse()});
  }
  TwoRuns(const TwoRuns&) = delete;

  std::vector<RunMatches> matches() const {
    return matchRuns(site, pairs, {0, 1}, submaps, oneByOne);
  }
};

TEST(MatchRuns, eachRunIsFoundInTheOther) {
  const TwoRuns two;
  const auto matches = two.matches();
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_EQ(matches[0].of, 0u);
  EXPECT_EQ(matches[0].in, 1u);
  EXPECT_EQ(matches[1].of, 1u);
  EXPECT_EQ(matches[1].in, 0u);
  for (const RunMatches& piece : matches)
    EXPECT_GT(double(piece.matches.size()), 0.9 * double(two.runs[piece.of].scans.size()));
}

TEST(MatchRuns, inABareMapItIsFoundAsInAFullOne) {
  TwoRuns two;
  const auto full = two.matches();
  dropLookUp(two.runs[1].map);
  const auto bare = two.matches();
  ASSERT_EQ(bare.size(), full.size());
  for (std::size_t k = 0; k < full.size(); ++k) {
    ASSERT_EQ(bare[k].matches.size(), full[k].matches.size());
    for (std::size_t m = 0; m < full[k].matches.size(); ++m) {
      EXPECT_EQ(bare[k].matches[m].in, full[k].matches[m].in);
      EXPECT_EQ(bare[k].matches[m].weight, full[k].matches[m].weight);
    }
  }
}

TEST(MatchRuns, runsThatWereNotRelatedHaveNone) {
  TwoRuns two;
  two.pairs = MapPairs(2, {});
  EXPECT_TRUE(two.matches().empty());
}

}  // namespace
}  // namespace roomgraph
