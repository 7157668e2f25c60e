#include "keep_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "RandomNumbers.h"
#include "drawn_building.h"
#include "roomgraph/align/wall_map.h"

namespace roomgraph {
namespace {

/** Three maps, and what is kept of their pairs. */
class KeepPairs : public ::testing::Test {
 protected:
  KeepPairs() : runs_(3) {
    for (std::size_t i = 0; i < 3; ++i)
      runs_[i].map = wallMap(test::drawnBuilding(1, {double(i), 0, 0}));
  }

  MapPair related(const PairOver& pair, const std::string& how = "searched") {
    const RelatePair work = [&](const PairOver&, FullMaps&) {
      ++worked_;
      MapPair found;
      found.alignment.confidence = 0.25;
      return found;
    };
    FullMaps maps;
    return keepPairs(work, runs_, how, kept_)(pair, maps);
  }

  std::vector<roomgraph::Run> runs_;
  std::map<std::string, std::string> shelf_;
  int worked_ = 0;
  KeptPairs kept_{[&](const std::string& name) -> std::optional<std::string> {
                    const auto found = shelf_.find(name);
                    return found == shelf_.end() ? std::nullopt : std::optional(found->second);
                  },
                  [&](const std::string& name, const std::string& bytes) { shelf_[name] = bytes; }};
};

TEST_F(KeepPairs, whatIsKeptIsNotWorkedOutAgain) {
  EXPECT_EQ(related({0, 0, 1}).alignment.confidence, 0.25);
  EXPECT_EQ(related({0, 0, 1}).alignment.confidence, 0.25);
  EXPECT_EQ(worked_, 1);
}

TEST_F(KeepPairs, otherMapsAnotherHubAndAnotherWayAreOtherPairs) {
  related({0, 0, 1}), related({0, 0, 2}), related({2, 0, 1}), related({0, 0, 1}, "aligned");
  EXPECT_EQ(worked_, 4);
  EXPECT_EQ(shelf_.size(), 4u);
}

TEST_F(KeepPairs, aPairIsTheSameOverEitherOfBoth) {
  related({0, 0, 1}), related({1, 0, 1});
  EXPECT_EQ(worked_, 1);
}

TEST_F(KeepPairs, whatIsDamagedIsWorkedOutAgain) {
  related({0, 0, 1});
  shelf_.begin()->second.back() ^= 1;
  related({0, 0, 1});
  EXPECT_EQ(worked_, 2);
}

TEST_F(KeepPairs, withoutAShelfAllIsWorkedOut) {
  kept_ = {};
  related({0, 0, 1}), related({0, 0, 1});
  EXPECT_EQ(worked_, 2);
}

/** A map of 100 m about the origin with so many patches. */
WallMap withPatches(std::size_t count) {
  WallMap map;
  map.frame = {1000, 1000, 0.1, {-50, -50}};
  map.patches.resize(count);
  return map;
}

AlignmentCandidate anyCandidate(test::RandomNumbers& random) {
  AlignmentCandidate any;
  any.pose = random.pose(30);
  any.evidence.close = random.between(0, 9), any.evidence.loose = random.between(0, 9);
  any.evidence.slightly = random.between(0, 9), any.evidence.contradicted = random.between(0, 9);
  any.evidence.known = random.between(0, 9), any.evidence.all = random.between(0, 9);
  any.evidence.weakest = random.between(0, 9), any.evidence.overlap = random.between(0, 1);
  any.evidence.common = random.between(0, 9), any.evidence.freeOnWall = random.between(0, 1);
  any.score = random.between(-50, 50);
  return any;
}

FollowedWalls anyWalls(test::RandomNumbers& random, std::size_t patches) {
  FollowedWalls any;
  any.pose = random.pose(30);
  any.bend = random.between(0, 3), any.share = random.between(0, 1);
  for (std::uint32_t i = 0; i < patches; ++i)
    any.patches.push_back(
        {i, random.pose(30), std::floor(random.between(1, 40)), int(random.below(3))});
  return any;
}

MapPair anyPair(std::uint32_t seed) {
  test::RandomNumbers random(seed);
  MapPair any;
  Alignment& alignment = any.alignment;
  alignment.pose = random.pose(30);
  alignment.confidence = random.between(0, 1), alignment.siteConfidence = random.between(0, 1);
  alignment.overlap = random.between(0, 1), alignment.runnerUpConfidence = random.between(0, 1);
  alignment.isSameSite = seed % 2 == 0, alignment.isAmbiguous = seed % 3 == 0;
  if (seed % 4 > 0) alignment.best = anyCandidate(random);
  if (seed % 4 > 1) alignment.runnerUp = anyCandidate(random);
  for (std::size_t i = 0; i < seed % 5; ++i) alignment.poses.push_back(random.pose(30));
  any.bInA = anyWalls(random, seed % 7), any.aInB = anyWalls(random, seed % 6);
  any.areIdentical = seed % 5 == 0, any.areEdits = seed % 2 == 0;
  any.areStoreys = seed % 4 == 3;
  alignment.isMirrored = seed % 3 == 1;
  return any;
}

TEST(PairBytes, holdAllOfAPairExactly) {
  const WallMap map = withPatches(8);
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const MapPair pair = anyPair(seed);
    const auto read = pairOfBytes(pairBytes(pair), map, map);
    ASSERT_TRUE(read) << seed;
    EXPECT_EQ(pairBytes(*read), pairBytes(pair));
  }
}

TEST(PairBytes, eachFieldChangesThem) {
  const MapPair pair = anyPair(23);  // it has all
  const std::string bytes = pairBytes(pair);
  const std::vector<std::function<void(MapPair&)>> changes{
      [](MapPair& p) { p.areIdentical = !p.areIdentical; },
      [](MapPair& p) { p.areEdits = !p.areEdits; },
      [](MapPair& p) { p.areStoreys = !p.areStoreys; },
      [](MapPair& p) { p.alignment.isMirrored = !p.alignment.isMirrored; },
      [](MapPair& p) { p.alignment.isSameSite = !p.alignment.isSameSite; },
      [](MapPair& p) { p.alignment.isAmbiguous = !p.alignment.isAmbiguous; },
      [](MapPair& p) { p.alignment.pose.phi = 99; },
      [](MapPair& p) { p.alignment.confidence = 2; },
      [](MapPair& p) { p.alignment.siteConfidence = 2; },
      [](MapPair& p) { p.alignment.runnerUpConfidence = 2; },
      [](MapPair& p) { p.alignment.overlap = 2; },
      [](MapPair& p) { p.alignment.best->pose.x = 99; },
      [](MapPair& p) { p.alignment.best->score = 99; },
      [](MapPair& p) { p.alignment.runnerUp.reset(); },
      [](MapPair& p) { p.alignment.poses.pop_back(); },
      [](MapPair& p) { p.alignment.poses[0].y = 99; },
      [](MapPair& p) { p.bInA.patches[0].patch = 7; },
      [](MapPair& p) { p.bInA.patches[0].walls = 99; },
      [](MapPair& p) { p.bInA.patches[0].layer = 7; },
      [](MapPair& p) { p.bInA.patches[0].pose.y = 99; },
      [](MapPair& p) { p.bInA.pose.y = 99; },
      [](MapPair& p) { p.bInA.bend = 99; },
      [](MapPair& p) { p.bInA.share = 2; },
      [](MapPair& p) { p.bInA.misfit = 99; },
      [](MapPair& p) { std::swap(p.aInB, p.bInA); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    MapPair changed = pair;
    changes[i](changed);
    EXPECT_NE(pairBytes(changed), bytes) << i;
  }
  using Evidence = AlignmentEvidence;
  for (double Evidence::*figure :
       {&Evidence::close, &Evidence::loose, &Evidence::slightly, &Evidence::contradicted,
        &Evidence::known, &Evidence::all, &Evidence::weakest, &Evidence::overlap, &Evidence::common,
        &Evidence::freeOnWall}) {
    MapPair changed = pair;
    changed.alignment.best->evidence.*figure = 99;
    EXPECT_NE(pairBytes(changed), bytes);
  }
}

TEST(PairBytes, areNotReadForMapsWithFewerPatches) {
  const MapPair pair = anyPair(13);  // six patches of b in a, one of a in b
  ASSERT_EQ(pair.bInA.patches.size(), 6u);
  ASSERT_EQ(pair.aInB.patches.size(), 1u);
  const std::string bytes = pairBytes(pair);
  EXPECT_TRUE(pairOfBytes(bytes, withPatches(1), withPatches(6)));
  EXPECT_FALSE(pairOfBytes(bytes, withPatches(1), withPatches(5)));
  EXPECT_FALSE(pairOfBytes(bytes, withPatches(0), withPatches(6)));
}

TEST(PairBytes, ofAnotherKindAreNotRead) {
  std::string bytes = pairBytes(anyPair(13));
  const WallMap map = withPatches(8);
  ASSERT_TRUE(pairOfBytes(bytes, map, map));
  bytes.replace(bytes.find('\n') - 1, 1, "1");
  EXPECT_FALSE(pairOfBytes(bytes, map, map));
  EXPECT_FALSE(pairOfBytes("", map, map));
}

TEST(Fingerprint, tellsMapsApartByAllThatRelatingThemDependsOn) {
  const WallMap map = wallMap(test::drawnBuilding(1, {}));
  const std::string same = fingerprint(map);
  EXPECT_EQ(same.size(), 64u);
  const std::vector<std::function<void(WallMap&)>> changes{
      [](WallMap& m) { m.frame.resolution *= 1.01; },
      [](WallMap& m) { m.frame.origin.y -= 0.01; },
      [](WallMap& m) { ++m.frame.width; },
      [](WallMap& m) { m.walls.back().place.x += 1e-9; },
      [](WallMap& m) {
        m.walls.front().normal = {0, 1};
      },
      [](WallMap& m) { m.walls.pop_back(); },
      [](WallMap& m) { m.states[m.states.size() / 3] = State::occupied; },
      [](WallMap& m) { m.hasScans = !m.hasScans; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    WallMap changed = map;
    changes[i](changed);
    EXPECT_NE(fingerprint(changed), same) << i;
  }
}

}  // namespace
}  // namespace roomgraph
