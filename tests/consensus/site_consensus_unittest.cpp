#include "roomgraph/consensus/site_consensus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "drawn_pose_graph.h"
#include "refine_poses.h"
#include "roomgraph/align/shared_edges.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/place_runs.h"
#include "sample_drives.h"

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

/** Where a run of the site lies. */
Way wayOf(const Consensus& consensus, std::size_t run) {
  Way way;
  for (const NodeId node : consensus.nodesOf(run)) way.push_back(consensus.poses[node]);
  return way;
}

/** Root mean square distance of all runs from where they should lie [m]. */
double misplaced(const Consensus& consensus, const std::vector<Way>& truth) {
  std::vector<Way> ways;
  for (std::size_t run = 0; run < truth.size(); ++run) ways.push_back(wayOf(consensus, run));
  return test::misplaced(test::posesOf(ways), truth);
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
      runs.back().map = wallMap(test::mapDrawnBy(frames));
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
  EXPECT_LT(misplaced(result, {truth, truth, truth}), 0.1);
  for (const double error : {result.errorOf(0).error, result.errorOf(2).error})
    EXPECT_LT(error, 0.1);
  PoseGraph alone;
  alone.addRun(true);
  for (const NodeId node : result.nodesOf(1)) {
    const PoseNode& drawn = result.graph.nodes[node];
    alone.addNode(drawn.pose, drawn.points, drawn.axes);
  }
  const double really = mapErrors(alone, test::posesOf({truth}))[RunId(0)].error;
  EXPECT_NEAR(result.errorOf(1).error, really, 0.05 * really);
}

TEST(RefinePoses, aStretchGoesToWhereItsScansFit) {
  const Transform2D there{3, -2, 0.4};
  const DrivenSite site({drive(), otherLog(moved(drive(), there), 2000)}, {{}, there.inverse()});
  Consensus consensus = site.consensus();
  const Way truth = wayOf(drive());
  const auto nodes = consensus.nodesOf(1);
  const auto push = [&] {
    for (std::size_t k = 20; k < 25; ++k)
      consensus.poses[nodes[k]] = consensus.poses[nodes[k]] * Transform2D{0.3, -0.2, 0.2};
  };
  push();
  const double before = misplaced(consensus, {truth, truth});
  const double told = consensus.errorOf(1).error;
  refinePoses(consensus, site.site, site.pairs, oneByOne);
  EXPECT_LT(misplaced(consensus, {truth, truth}), 0.3 * before);
  EXPECT_EQ(consensus.errorOf(1).error, told);
}

TEST(RefinePoses, aReferenceStaysAsItIs) {
  DrivenSite site({drive(), otherLog(drive(), 2000)}, {{}, {}});
  site.site.reference = 0;
  Consensus consensus = site.consensus();
  refinePoses(consensus, site.site, site.pairs, oneByOne);
  for (std::size_t k = 0; k < drive().size(); ++k) {
    const Transform2D& pose = consensus.poses[consensus.nodesOf(0)[k]];
    EXPECT_EQ(pose.x, drive()[k].pose.x) << k;
    EXPECT_EQ(pose.phi, drive()[k].pose.phi) << k;
  }
}

/** The drive with scans that fit nowhere: as if in a round cell. */
std::vector<Keyframe> lostAt(std::vector<Keyframe> frames, std::size_t first, std::size_t count) {
  for (std::size_t k = first; k < first + count; ++k)
    for (Point& end : frames[k].ends) end = (0.4 / norm(end)) * end;
  return frames;
}

TEST(SiteConsensus, scansThatFitNowhereThoughThePlaceIsKnownAreContradicted) {
  std::vector<std::vector<Keyframe>> drives{drive()};
  for (const int other : {1, 2, 3})
    drives.push_back(
        otherLog(test::drifting(drive(), 0.0002 * other), std::uint64_t(1000 + other * 1000)));
  DrivenSite site(drives, {{}, {}, {}, {}});
  site.runs[0].scans = scanWalls(lostAt(drive(), 4, 9));
  const Consensus result = site.consensus();
  const MapError error = result.errorOf(0);
  EXPECT_GT(error.contradicted, 0);
  EXPECT_GT(error.high, 0.4) << "they may lie anywhere";
  EXPECT_FALSE(error.isConfirmed[8]);
  EXPECT_TRUE(error.isConfirmed[20]);
  EXPECT_EQ(result.errorOf(1).contradicted, 0) << "it is not theirs";
}

/** What a scanner of less range would have met. */
std::vector<Keyframe> nearSighted(std::vector<Keyframe> frames, double range) {
  for (Keyframe& frame : frames)
    frame.ends.erase(std::remove_if(frame.ends.begin(), frame.ends.end(),
                                    [&](Point end) { return norm(end) > range; }),
                     frame.ends.end());
  return frames;
}

TEST(SiteConsensus, aWingThatNobodyElseHasSeenIsNotConfirmedAndCostsNothing) {
  const std::vector<Keyframe> half = nearSighted({drive().begin(), drive().begin() + 14}, 4);
  const DrivenSite site({drive(), otherLog(half, 2000), otherLog(half, 3000)}, {{}, {}, {}});
  const Consensus result = site.consensus();
  const MapError error = result.errorOf(0);
  EXPECT_LT(error.error, 0.05);
  EXPECT_GT(error.confirmed, 0.3);
  EXPECT_LT(error.confirmed, 0.9);
  EXPECT_EQ(error.contradicted, 0);
  ASSERT_EQ(error.isConfirmed.size(), drive().size());
  EXPECT_TRUE(error.isConfirmed[5]);
  EXPECT_FALSE(error.isConfirmed.back());
  EXPECT_EQ(result.errorOf(1).confirmed, 1);
}

TEST(SiteConsensus, whatOthersKnowOtherwiseIsContradictedAndMayLieAnywhere) {
  std::vector<std::vector<Keyframe>> drives{drive(),
                                            otherLog(test::drifting(drive(), 0.0002), 2000),
                                            otherLog(test::drifting(drive(), 0.0004), 3000)};
  DrivenSite site(drives, {{}, {}, {}});
  const double before = site.consensus().errorOf(0).high;
  site.runs[0].scans = scanWalls(lostAt(drive(), 10, 13));
  const Consensus result = site.consensus();
  EXPECT_GT(result.errorOf(0).contradicted, 0);
  EXPECT_LT(result.errorOf(0).confirmed, 1);
  EXPECT_GT(result.errorOf(0).high, before);
  EXPECT_FALSE(result.errorOf(0).isConfirmed[16]);
  EXPECT_TRUE(result.errorOf(0).isConfirmed[2]);
  EXPECT_EQ(result.errorOf(1).contradicted, 0);
}

TEST(SiteConsensus, scansThatAreOffOnTheirOwnCostWhatTheyAreOff) {
  const auto shaken = otherLog(test::shaken(drive(), 0.1), 2000);
  const DrivenSite site({drive(), shaken, otherLog(drive(), 3000)}, {{}, {}, {}});
  const Consensus result = site.consensus();
  EXPECT_GT(result.errorOf(1).error, 0.09);
  EXPECT_LT(result.errorOf(1).error, 0.2);
  EXPECT_LT(result.errorOf(0).error, 0.03);
}

TEST(SiteConsensus, aTornEndIsToldByItsOwnScansThoughTheyAreFew) {
  const auto torn = otherLog(broken(drive(), drive().size() - 2, 0.8, {}), 2000);
  const DrivenSite site({drive(), torn, otherLog(test::drifting(drive(), 0.0002), 3000)},
                        {{}, {}, {}});
  const Consensus result = site.consensus();
  const Way truth = wayOf(drive());
  EXPECT_LT(misplaced(result, {truth, truth, truth}), 0.1);
  EXPECT_GT(result.errorOf(1).error, 0.3);
  EXPECT_LT(result.errorOf(0).high, 0.1);
}

TEST(SiteConsensus, ofTwoRunsTheirOwnScansTellWhichIsTorn) {
  for (const bool isFirstTorn : {true, false}) {
    const auto torn = otherLog(broken(drive(), 20, M_PI / 2, {3, 4}), 2000);
    const auto whole = otherLog(test::drifting(drive(), 0.0002), 3000);
    const DrivenSite site(isFirstTorn ? std::vector{torn, whole} : std::vector{whole, torn},
                          {{}, {}});
    const Consensus result = site.consensus();
    EXPECT_GT(result.errorOf(isFirstTorn ? 0 : 1).low, 0.5);
    EXPECT_LT(result.errorOf(isFirstTorn ? 1 : 0).high, 0.2);
  }
}

TEST(SiteConsensus, copiesOfAMapShareOneResult) {
  const DrivenSite site({drive(), otherLog(test::drifting(drive(), 0.004), 2000), drive()},
                        {{}, {}, {}});
  const Consensus result = site.consensus();
  ASSERT_EQ(result.graphRuns.size(), 3u);
  EXPECT_EQ(result.graph.runs.size(), 2u);
  EXPECT_EQ(result.errorOf(0).error, result.errorOf(2).error);
  EXPECT_EQ(result.errorOf(0).high, result.errorOf(2).high);
  EXPECT_EQ(result.nodesOf(0).front(), result.nodesOf(2).front());
  const DrivenSite two({drive(), otherLog(test::drifting(drive(), 0.004), 2000)}, {{}, {}});
  EXPECT_EQ(two.consensus().errorOf(0).error, result.errorOf(0).error) << "a copy has no vote";
}

TEST(SiteConsensus, ofACopyWithoutScansTheOneWithScansCounts) {
  DrivenSite site({drive(), otherLog(test::drifting(drive(), 0.004), 2000), drive()}, {{}, {}, {}});
  const Consensus before = site.consensus();
  site.runs[0].scans.clear();
  const Consensus after = site.consensus();
  EXPECT_EQ(after.nodesOf(2).size(), site.runs[2].scans.size());
  EXPECT_EQ(after.errorOf(2).error, before.errorOf(2).error);
  EXPECT_EQ(after.errorOf(0).error, before.errorOf(0).error);
}

TEST(SiteConsensus, whereAllAreCopiesThereIsNoError) {
  const DrivenSite site({drive(), drive()}, {{}, {}});
  const Consensus result = site.consensus();
  for (const std::size_t run : {0u, 1u}) {
    EXPECT_LT(result.errorOf(run).error, 0.001) << "its axes may straighten it by a hair";
    EXPECT_EQ(result.errorOf(run).seen, 1);
  }
}

TEST(SiteConsensus, aReferenceStaysAsItIsAndTheOthersFollowIt) {
  DrivenSite site({drive(), otherLog(test::drifting(drive(), 0.004), 2000)}, {{}, {}});
  site.site.reference = 1;
  const Consensus result = site.consensus();
  const Way bent = wayOf(test::drifting(drive(), 0.004));
  EXPECT_LT(test::misplaced(wayOf(result, 1), bent), 1e-6);
  EXPECT_NEAR(result.errorOf(1).error, 0, 1e-6);
  EXPECT_LT(misplaced(result, {bent, bent}), 0.1);
}

TEST(SiteConsensus, theSameScansBindRunsWhoseMapsHaveNothingInCommon) {
  const auto smeared = test::drifting(drive(), 0.05);  // its map is no help
  DrivenSite bound({drive(), smeared}, {{}, {}}), apart({drive(), otherLog(smeared, 9)}, {{}, {}});
  for (DrivenSite* site : {&bound, &apart}) {
    site->site.reference = 0;
    site->pairs = MapPairs(2);  // none of their walls were followed
  }
  const Way truth = wayOf(drive());
  EXPECT_GT(test::displacement(wayOf(smeared), truth), 1);
  const Consensus result = bound.consensus();
  EXPECT_LT(misplaced(result, {truth, truth}), 0.05);
  EXPECT_EQ(result.errorOf(1).seen, 1);
  const Consensus without = apart.consensus();
  EXPECT_LT(test::misplaced(wayOf(without, 1), wayOf(smeared)), 0.001);
  EXPECT_EQ(without.errorOf(1).seen, 0) << "nobody has seen it";
}

TEST(SiteConsensus, whoIsNotOfTheCoreIsHeldAgainstIt) {
  const auto torn = otherLog(broken(drive(), 20, M_PI / 2, {3, 4}), 4000);
  const auto bent = otherLog(test::drifting(drive(), 0.006), 5000);
  const std::vector<std::vector<Keyframe>> drives{bent, drive(), torn, otherLog(drive(), 2000),
                                                  otherLog(moved(drive(), {3, 2, 1}), 3000)};
  DrivenSite site(drives, {{}, {}, {}, {}, Transform2D{3, 2, 1}.inverse()});
  const Consensus all = site.consensus();
  site.pairs.core = {1, 3, 4};
  const Consensus some = site.consensus();
  for (const std::size_t run : {0, 2}) {
    ASSERT_GT(all.errorOf(run).error, 0.15);
    EXPECT_NEAR(some.errorOf(run).error, all.errorOf(run).error, 0.05 * all.errorOf(run).error);
  }
  DrivenSite core({drives[1], drives[3], drives[4]}, {{}, {}, site.site.poses[4]});
  for (std::size_t run = 0; run < 3; ++run)
    EXPECT_EQ(core.consensus().errorOf(run).error, some.errorOf(site.pairs.core[run]).error)
        << "the others have no say";
}

TEST(SiteConsensus, theOrderOfTheJobsChangesNothing) {
  const DrivenSite site({drive(), otherLog(broken(drive(), 20, 0.3, {}), 2000)}, {{}, {}});
  const ForEach backwards = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count > 0) job(--count);
  };
  const Consensus l = site.consensus(), r = site.consensus(backwards);
  for (std::size_t run = 0; run < 2; ++run) EXPECT_EQ(l.errorOf(run).error, r.errorOf(run).error);
  for (const NodeId node : l.poses.ids()) EXPECT_EQ(l.poses[node].shift(), r.poses[node].shift());
}

TEST(SiteConsensus, ofRunsWithoutScansNothingIsFound) {
  std::vector<roomgraph::Run> runs(2);
  Site site;
  for (roomgraph::Run& run : runs) {
    run.map = wallMap(test::drawnBuilding(1, {}));
    site.runs.push_back(&run);
  }
  site.poses.assign(2, {});
  const Consensus result = siteConsensus(site, MapPairs(2), DistinctMaps(PairBends(2)), oneByOne);
  EXPECT_EQ(result.errorOf(1).seen, 0);
  EXPECT_TRUE(result.nodesOf(1).isEmpty());
  EXPECT_FALSE(result.isCounted(1));
}

}  // namespace
}  // namespace roomgraph
