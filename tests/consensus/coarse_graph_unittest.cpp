#include "coarse_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_submaps.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

/** Two runs in frames of their own, and what they find of each other. */
struct TwoRuns {
  std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3)};
  std::vector<RunSubmaps> runs{drawnSubmaps(truth[0]),
                               drawnSubmaps(test::moved(truth[1], {7, -3, 2}))};
  std::vector<RunMatches> matches = test::exactMatches(truth);
};

double farthest(const SubmapPoses& l, const SubmapPoses& r) {
  double most = 0;
  for (std::size_t run = 0; run < l.size(); ++run)
    for (std::size_t k = 0; k < l[run].size(); ++k)
      most = std::max({most, distance(l[run][k].shift(), r[run][k].shift()),
                       std::abs(wrappedAngle(l[run][k].phi - r[run][k].phi))});
  return most;
}

TEST(CoarseGraph, hasAboutAQuarterOfTheSubmaps) {
  const TwoRuns two;
  const CoarseGraph coarse = coarseGraph(two.runs, two.matches);
  for (std::size_t r = 0; r < 2; ++r) {
    const std::size_t all = two.runs[r].submaps.size(), few = coarse.runs[r].submaps.size();
    EXPECT_GE(4 * few, all);
    EXPECT_LE(4 * few, all + 12);
    EXPECT_EQ(coarse.runs[r].links.size(), few - 1);
  }
}

TEST(CoarseGraph, whatHoldsOfAllHoldsOfTheCoarseOnes) {
  const TwoRuns two;
  const CoarseGraph coarse = coarseGraph(two.runs, two.matches);
  const SubmapPoses poses = coarsePoses(coarse, two.truth);
  std::size_t matches = 0;
  for (const RunMatches& piece : coarse.matches)
    for (const SubmapMatch& match : piece.matches) {
      const Transform2D there = poses[piece.in][match.in] * match.pose;
      EXPECT_LT(distance(there.shift(), poses[piece.of][match.submap].shift()), 1e-9);
      ++matches;
    }
  EXPECT_GT(matches, 50u);
}

TEST(CoarseGraph, allSubmapsGoWhereTheirCoarseOnesGo) {
  const TwoRuns two;
  const CoarseGraph coarse = coarseGraph(two.runs, two.matches);
  EXPECT_LT(farthest(finePoses(coarse, two.truth, coarsePoses(coarse, two.truth)), two.truth),
            1e-9);
  const Transform2D motion{3, -8, 1};
  SubmapPoses moved = two.truth;
  for (Transform2D& pose : moved[1]) pose = motion * pose;
  EXPECT_LT(farthest(finePoses(coarse, two.truth, coarsePoses(coarse, moved)), moved), 1e-9);
}

TEST(CoarseGraph, nothingIsJoinedAcrossTheEndOfAPiece) {
  TwoRuns two;
  RunMatches& piece = two.matches.front();
  const auto end = std::find_if(piece.matches.begin(), piece.matches.end(),
                                [](const SubmapMatch& m) { return m.submap >= 21; });
  ASSERT_NE(end, piece.matches.end());
  piece.matches.erase(end, piece.matches.end());
  const std::uint32_t last = piece.matches.back().submap;
  const CoarseGraph coarse = coarseGraph(two.runs, two.matches);
  const auto& nodeOf = coarse.nodeOf[piece.of];
  EXPECT_NE(nodeOf[last], nodeOf[last + 1]);
}

TEST(CoarseGraph, patchesStayAsTheyAre) {
  TwoRuns two;
  two.runs[1].areScans = false;
  const CoarseGraph coarse = coarseGraph(two.runs, two.matches);
  EXPECT_EQ(coarse.runs[1].submaps.size(), two.runs[1].submaps.size());
  EXPECT_LT(coarse.runs[0].submaps.size(), two.runs[0].submaps.size());
}

TEST(CoarseGraph, ofNothingIsNothing) {
  const std::vector<RunSubmaps> runs(2);
  const CoarseGraph coarse = coarseGraph(runs, {});
  EXPECT_EQ(coarse.runs.size(), 2u);
  for (const Way& way : finePoses(coarse, SubmapPoses(2), SubmapPoses(2))) EXPECT_TRUE(way.empty());
}

}  // namespace
}  // namespace roomgraph
