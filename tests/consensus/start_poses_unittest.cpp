#include "start_poses.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_submaps.h"

namespace roomgraph {
namespace {

using test::drawnSubmaps;
using test::roundTheBlock;
using test::Way;

constexpr double kExact = 1e-9;

void expectSame(const Way& l, const Way& r) {
  ASSERT_EQ(l.size(), r.size());
  for (std::size_t k = 0; k < l.size(); ++k) {
    EXPECT_LT(distance(l[k].shift(), r[k].shift()), kExact) << k;
    EXPECT_LT(std::abs(wrappedAngle(l[k].phi - r[k].phi)), kExact) << k;
  }
}

TEST(StartPoses, eachSubmapLiesWhereItWasFoundInThePivot) {
  const Way way = roundTheBlock(), other = roundTheBlock(0.4);
  const std::vector<RunSubmaps> runs{
      drawnSubmaps(way), drawnSubmaps(test::torn(test::moved(other, {7, -3, 2}), 30, 1, {4, 5}))};
  const SubmapPoses poses = startPoses(runs, test::exactMatches({way, other}), 0);
  expectSame(poses[0], way);
  expectSame(poses[1], other);
}

TEST(StartPoses, aMatchNamedTheOtherWayRoundSaysTheSame) {
  const Way way = roundTheBlock();
  const std::vector<RunSubmaps> runs{drawnSubmaps(way), drawnSubmaps(test::moved(way, {7, -3, 2}))};
  for (const RunMatches& pair : test::exactMatches({way, way}))
    expectSame(startPoses(runs, {pair}, 0)[1], way);
}

TEST(StartPoses, theFrameIsThatOfThePivot) {
  const Way way = roundTheBlock(), there = test::moved(way, {7, -3, 2});
  const std::vector<RunSubmaps> runs{drawnSubmaps(way), drawnSubmaps(there)};
  const SubmapPoses poses = startPoses(runs, test::exactMatches({way, way}), 1);
  expectSame(poses[0], there);
  expectSame(poses[1], there);
}

TEST(StartPoses, whatWasNotFoundGoesWithTheNearestThatWas) {
  const Way way = roundTheBlock(), drawn = test::torn(way, 30, 1, {4, 5});
  std::vector<RunMatches> matches = test::exactMatches({way, way});
  for (RunMatches& pair : matches) pair.matches = {pair.matches[10], pair.matches[50]};
  const Way spread = startPoses({drawnSubmaps(way), drawnSubmaps(drawn)}, matches, 0)[1];
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (k == 30) continue;  // as near to the one as to the other
    EXPECT_LT(distance(spread[k].shift(), way[k].shift()), kExact) << k;
  }
}

TEST(StartPoses, aRunIsPlacedThroughAnother) {
  const Way way = roundTheBlock();
  std::vector<RunMatches> matches;
  for (const RunMatches& pair : test::exactMatches({way, way, way}))
    if (pair.of == 1 || pair.in == 1) matches.push_back(pair);  // 0 and 2 never met
  const std::vector<RunSubmaps> runs{drawnSubmaps(way), drawnSubmaps(test::moved(way, {7, -3, 2})),
                                     drawnSubmaps(test::moved(way, {-1, 9, -1}))};
  for (const Way& poses : startPoses(runs, matches, 0)) expectSame(poses, way);
}

TEST(StartPoses, aRunThatWasFoundNowhereKeepsItsPoses) {
  const Way way = roundTheBlock(), there = test::moved(way, {7, -3, 2});
  const SubmapPoses poses = startPoses({drawnSubmaps(way), drawnSubmaps(there), {}}, {}, 0);
  expectSame(poses[0], way);
  expectSame(poses[1], there);
  EXPECT_TRUE(poses[2].empty());
}

TEST(StartPoses, eachPivotBringsSoundRunsTogetherAlike) {
  const std::vector<Way> truth{roundTheBlock(), roundTheBlock(0.3), roundTheBlock(0.6)};
  const std::vector<RunSubmaps> runs{drawnSubmaps(truth[0]),
                                     drawnSubmaps(test::moved(truth[1], {7, -3, 2})),
                                     drawnSubmaps(test::moved(truth[2], {-1, 9, -1}))};
  const auto matches = test::exactMatches(truth);
  for (const std::size_t pivot : {0u, 1u, 2u}) {
    const SubmapPoses poses = startPoses(runs, matches, pivot);
    EXPECT_LT(test::misplaced(poses, truth), kExact);
    for (std::size_t k = 0; k < truth[pivot].size(); ++k)
      EXPECT_EQ(poses[pivot][k].shift(), runs[pivot].submaps[k].pose.shift()) << "in its frame";
  }
}

TEST(StartPoses, whatThePivotSaysGoesBeforeWhatOthersSay) {
  const Way way = roundTheBlock();
  const std::vector<RunSubmaps> runs(3, drawnSubmaps(way));
  std::vector<RunMatches> matches = test::exactMatches({way, way, way});
  std::size_t misled = 0;
  for (RunMatches& pair : matches)
    if (pair.of + pair.in == 3)  // 1 and 2, which say of each other what is wrong
      for (SubmapMatch& match : pair.matches) match.pose.x += 5, ++misled;
  ASSERT_GT(misled, 0u);
  for (const Way& poses : startPoses(runs, matches, 0)) expectSame(poses, way);
}

TEST(StartPoses, ofTwoMatchesOfASubmapTheFirstCounts) {
  const Way way = roundTheBlock();
  std::vector<RunMatches> matches = test::exactMatches({way, way});
  RunMatches wrong = matches.front();
  for (SubmapMatch& match : wrong.matches) match.pose.x += 5;
  matches.push_back(wrong);
  expectSame(startPoses({drawnSubmaps(way), drawnSubmaps(way)}, matches, 0)[1], way);
}

TEST(StartPoses, aPartThatNoLinkJoinsGoesWithTheFirstThatWasFound) {
  const Way way = roundTheBlock(), there = test::moved(way, {7, -3, 2});
  RunSubmaps cut = drawnSubmaps(there);
  cut.links.erase(cut.links.begin() + 39);  // 39 and 40
  std::vector<RunMatches> matches = test::exactMatches({way, way});
  for (RunMatches& pair : matches) pair.matches.resize(10);
  expectSame(startPoses({drawnSubmaps(way), cut}, matches, 0)[1], way);
}

}  // namespace
}  // namespace roomgraph
