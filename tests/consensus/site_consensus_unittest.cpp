#include "roomgraph/consensus/site_consensus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "drawn_submaps.h"
#include "roomgraph/align/are_identical.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

using test::broken;
using test::moved;
using test::Way;

/** A drive through a building, each scan with a name of its own. */
const std::vector<Keyframe>& drive() {
  static const std::vector<Keyframe> the = [] {
    std::vector<Keyframe> frames = test::drawnDrive(test::drawnBuilding(4, {}));
    for (std::size_t k = 0; k < frames.size(); ++k) frames[k].scanId = 1000 + k;
    return frames;
  }();
  return the;
}

/** The drive as another log of it. */
std::vector<Keyframe> otherLog(std::vector<Keyframe> frames, std::uint64_t first) {
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k].scanId = first + k;
  return frames;
}

std::vector<Keyframe> drifting(std::vector<Keyframe> frames, double turn) {
  for (std::size_t i = 1; i < frames.size(); ++i) frames = broken(frames, i, turn, {});
  return frames;
}

Way wayOf(const std::vector<Keyframe>& frames) {
  Way way;
  for (const Keyframe& frame : frames) way.push_back(frame.pose);
  return way;
}

/** Runs that have drawn their maps from their scans, and how they lie in each other as wholes. */
struct DrivenSite {
  std::vector<roomgraph::Run> runs;
  Site site;
  MapPairs pairs;

  explicit DrivenSite(const std::vector<std::vector<Keyframe>>& drives,
                      const std::vector<Transform2D>& poses) {
    for (const std::vector<Keyframe>& frames : drives) {
      runs.emplace_back();
      runs.back().map = wallMap(test::mapDrawnBy(frames), {});
      runs.back().scans = scanWalls(frames);
    }
    for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
    site.poses = poses;
    pairs = MapPairs(runs.size());
    for (const auto& [i, j] : pairs.pairs()) {
      const WallMap &a = runs[i].map, &b = runs[j].map;
      pairs(i, j).areIdentical = areIdentical(a, b);
      follow(pairs(i, j), a, b, {poses[i].inverse() * poses[j]});
    }
  }
  DrivenSite(const DrivenSite&) = delete;

  Consensus consensus(const ForEach& forEach = oneByOne) const {
    return siteConsensus(site, pairs, DistinctMaps(bendsOf(pairs)), forEach);
  }
};

TEST(SiteConsensus, aTornRunIsPutTogetherAgain) {
  const Transform2D there{3, -2, 0.4};
  const auto torn = otherLog(broken(drive(), 20, M_PI / 2, {3, 4}), 2000);
  const DrivenSite site({drive(), torn, otherLog(moved(drive(), there), 3000)},
                        {{}, {}, there.inverse()});
  const Consensus result = site.consensus();
  const Way truth = wayOf(drive());
  EXPECT_LT(test::misplaced(result.poses, {truth, truth, truth}), 0.1);
  for (const double error : {result.errors[0].error, result.errors[2].error}) EXPECT_LT(error, 0.1);
  const double really = mapErrors({result.submaps[1]}, {}, {truth})[0].error;
  EXPECT_NEAR(result.errors[1].error, really, 0.05 * really);
}

/** The drive with scans that fit nowhere: as if in a round cell. */
std::vector<Keyframe> lostAt(std::vector<Keyframe> frames, std::size_t first, std::size_t count) {
  for (std::size_t k = first; k < first + count; ++k)
    for (Point& end : frames[k].ends) end = (0.4 / norm(end)) * end;
  return frames;
}

TEST(SiteConsensus, scansThatFitNowhereThoughThePlaceIsKnownCost) {
  std::vector<std::vector<Keyframe>> drives{drive()};
  for (const int other : {1, 2, 3})
    drives.push_back(
        otherLog(drifting(drive(), 0.0002 * other), std::uint64_t(1000 + other * 1000)));
  DrivenSite site(drives, {{}, {}, {}, {}});
  site.runs[0].scans = scanWalls(lostAt(drive(), 4, 9));
  const Consensus result = site.consensus();
  EXPECT_GT(result.errors[0].error, 0.2);
  EXPECT_GT(result.errors[0].high, 0.4);
  const std::vector<double>& each = result.errors[0].errors;
  EXPECT_GE(*std::max_element(each.begin() + 4, each.begin() + 13), 1);
  EXPECT_LT(each[20], 0.1);
  EXPECT_LT(result.errors[1].error, 0.1) << "it is not theirs";
}

TEST(SiteConsensus, copiesOfAMapShareOneResult) {
  const DrivenSite site({drive(), otherLog(drifting(drive(), 0.004), 2000), drive()}, {{}, {}, {}});
  const Consensus result = site.consensus();
  ASSERT_EQ(result.errors.size(), 3u);
  EXPECT_EQ(result.errors[0].error, result.errors[2].error);
  EXPECT_EQ(result.errors[0].high, result.errors[2].high);
  ASSERT_EQ(result.poses[0].size(), result.poses[2].size());
  for (std::size_t k = 0; k < result.poses[0].size(); ++k)
    EXPECT_EQ(result.poses[0][k].shift(), result.poses[2][k].shift());
  const DrivenSite two({drive(), otherLog(drifting(drive(), 0.004), 2000)}, {{}, {}});
  EXPECT_EQ(two.consensus().errors[0].error, result.errors[0].error) << "a copy has no vote";
}

TEST(SiteConsensus, ofACopyWithoutScansTheOneWithScansCounts) {
  DrivenSite site({drive(), otherLog(drifting(drive(), 0.004), 2000), drive()}, {{}, {}, {}});
  const Consensus before = site.consensus();
  site.runs[0].scans.clear();
  const Consensus after = site.consensus();
  EXPECT_EQ(after.poses[2].size(), site.runs[2].scans.size());
  EXPECT_EQ(after.errors[2].error, before.errors[2].error);
  EXPECT_EQ(after.errors[0].error, before.errors[0].error);
}

TEST(SiteConsensus, whereAllAreCopiesThereIsNoError) {
  const DrivenSite site({drive(), drive()}, {{}, {}});
  for (const MapError& error : site.consensus().errors) {
    EXPECT_LT(error.error, 0.001) << "its axes may straighten it by a hair";
    EXPECT_EQ(error.seen, 1);
  }
}

TEST(SiteConsensus, aReferenceStaysAsItIsAndTheOthersFollowIt) {
  DrivenSite site({drive(), otherLog(drifting(drive(), 0.004), 2000)}, {{}, {}});
  site.site.reference = 1;
  const Consensus result = site.consensus();
  const Way bent = wayOf(drifting(drive(), 0.004));
  EXPECT_LT(test::misplaced({result.poses[1]}, {bent}), 1e-6);
  EXPECT_NEAR(result.errors[1].error, 0, 1e-6);
  EXPECT_LT(test::misplaced(result.poses, {bent, bent}), 0.1);
}

TEST(SiteConsensus, theSameScansBindRunsWhoseMapsHaveNothingInCommon) {
  const auto smeared = drifting(drive(), 0.05);  // its map is no help
  DrivenSite bound({drive(), smeared}, {{}, {}}), apart({drive(), otherLog(smeared, 9)}, {{}, {}});
  for (DrivenSite* site : {&bound, &apart}) {
    site->site.reference = 0;
    site->pairs = MapPairs(2);  // none of their walls were followed
  }
  const Way truth = wayOf(drive());
  EXPECT_GT(test::displacement(wayOf(smeared), truth), 1);
  const Consensus result = bound.consensus();
  EXPECT_LT(test::misplaced(result.poses, {truth, truth}), 0.05);
  EXPECT_EQ(result.errors[1].seen, 1);
  const Consensus without = apart.consensus();
  EXPECT_LT(test::misplaced({without.poses[1]}, {wayOf(smeared)}), 0.001);
  EXPECT_EQ(without.errors[1].seen, 0) << "nobody has seen it";
}

TEST(SiteConsensus, whoIsNotOfTheCoreIsHeldAgainstIt) {
  const auto torn = otherLog(broken(drive(), 20, M_PI / 2, {3, 4}), 4000);
  const auto bent = otherLog(drifting(drive(), 0.006), 5000);
  const std::vector<std::vector<Keyframe>> drives{bent, drive(), torn, otherLog(drive(), 2000),
                                                  otherLog(moved(drive(), {3, 2, 1}), 3000)};
  DrivenSite site(drives, {{}, {}, {}, {}, Transform2D{3, 2, 1}.inverse()});
  const Consensus all = site.consensus();
  site.pairs.core = {1, 3, 4};
  const Consensus some = site.consensus();
  ASSERT_EQ(some.errors.size(), 5u);
  for (const std::size_t run : {0, 2}) {
    ASSERT_GT(all.errors[run].error, 0.15);
    EXPECT_NEAR(some.errors[run].error, all.errors[run].error, 0.05 * all.errors[run].error);
  }
  DrivenSite core({drives[1], drives[3], drives[4]}, {{}, {}, site.site.poses[4]});
  for (std::size_t run = 0; run < 3; ++run)
    EXPECT_EQ(core.consensus().errors[run].error, some.errors[site.pairs.core[run]].error)
        << "the others have no say";
}

TEST(SiteConsensus, theOrderOfTheJobsChangesNothing) {
  const DrivenSite site({drive(), otherLog(broken(drive(), 20, 0.3, {}), 2000)}, {{}, {}});
  const ForEach backwards = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count > 0) job(--count);
  };
  const Consensus l = site.consensus(), r = site.consensus(backwards);
  for (std::size_t run = 0; run < 2; ++run) {
    EXPECT_EQ(l.errors[run].error, r.errors[run].error);
    for (std::size_t k = 0; k < l.poses[run].size(); ++k)
      EXPECT_EQ(l.poses[run][k].shift(), r.poses[run][k].shift());
  }
}

TEST(SiteConsensus, ofRunsWithoutScansNothingIsFound) {
  std::vector<roomgraph::Run> runs(2);
  Site site;
  for (roomgraph::Run& run : runs) {
    run.map = wallMap(test::drawnBuilding(1, {}), {});
    site.runs.push_back(&run);
  }
  site.poses.assign(2, {});
  const Consensus result = siteConsensus(site, MapPairs(2), DistinctMaps(PairBends(2)), oneByOne);
  ASSERT_EQ(result.errors.size(), 2u);
  EXPECT_EQ(result.errors[0].seen, 0);
  ASSERT_EQ(result.submaps.size(), 2u);
  EXPECT_TRUE(result.submaps[1].submaps.empty());
  EXPECT_TRUE(result.poses[1].empty());
}

}  // namespace
}  // namespace roomgraph
