#include "roomgraph/consensus/errors_by_bends.h"

#include <gtest/gtest.h>

#include "drawn_bends.h"

namespace roomgraph {
namespace {

using test::bendsOf;

/** Runs of a site, with walls that are so far from right angles. */
struct SiteOfRuns {
  std::vector<roomgraph::Run> runs;
  Site site;

  explicit SiteOfRuns(const std::vector<double>& deviations) : runs(deviations.size()) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs[i].map.axisDeviation = deviations[i];
      site.runs.push_back(&runs[i]);
    }
    site.poses.resize(runs.size());
  }
  SiteOfRuns(const SiteOfRuns&) = delete;
};

TEST(ErrorsByBends, copiesOfAMapShareOneErrorAndHaveOneSay) {
  const SiteOfRuns three({0.01, 0.02, 0.03}), four({0.01, 0.02, 0.03, 0.02});
  const PairBends bends = bendsOf({0.1, 0.4, 0.8});
  PairBends withCopy = bendsOf({0.1, 0.4, 0.8, 0.4});
  withCopy(1, 3) = {0, 1, 1000, true};
  const auto before = errorsByBends(three.site, bends, DistinctMaps(bends));
  const auto after = errorsByBends(four.site, withCopy, DistinctMaps(withCopy));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(after[i].error, before[i].error) << i;
  EXPECT_EQ(after[3].error, after[1].error);
  EXPECT_EQ(after[3].high, after[1].high);
}

TEST(ErrorsByBends, theIntervalReachesToTheWallsOfTheOtherThatFitsBest) {
  const SiteOfRuns three({0.01, 0.01, 0.01});
  PairBends bends = bendsOf({0.02, 0.02, 0.02});
  const double before = errorsByBends(three.site, bends, DistinctMaps(bends))[0].high;
  bends(0, 1).misfit = 0.5, bends(0, 2).misfit = 0.4, bends(1, 2).misfit = 0.01;
  const auto errors = errorsByBends(three.site, bends, DistinctMaps(bends));
  EXPECT_EQ(errors[0].high, 0.4);
  EXPECT_NEAR(errors[1].high, before, 1e-6) << "another one has its walls where it has them";
}

TEST(ErrorsByBends, theIntervalHoldsWhatEitherWayOfAPairTells) {
  const SiteOfRuns two({0.01, 0.01});
  PairBends bends(2);
  const auto errorAt = [&](double bend, double agreement) {
    bends(0, 1) = {bend, 1, 1000, false};
    bends(0, 1).agreement = agreement;
    return errorsByBends(two.site, bends, DistinctMaps(bends))[0];
  };
  const MapError less = errorAt(0.5, 1), more = errorAt(10, 1), either = errorAt(10, 0.05);
  EXPECT_EQ(either.error, more.error);
  EXPECT_EQ(either.high, more.high);
  EXPECT_DOUBLE_EQ(either.low, less.low);
  EXPECT_LT(less.low, more.low / 5);
}

TEST(ErrorsByBends, editsOfAPictureHaveOneSayButEachItsOwnError) {
  const SiteOfRuns four({0.01, 0.01, 0.01, 0.01});
  PairBends bends = bendsOf({0.1, 0.1, 0.4, 0.4});
  bends(0, 1) = {0.01, 1, 1000, false, true};
  const auto alone = errorsByBends(four.site, bends, DistinctMaps(bends));
  bends(0, 1).areEdits = false;
  const auto outvoted = errorsByBends(four.site, bends, DistinctMaps(bends));
  EXPECT_LT(alone[2].error, outvoted[2].error) << "two drives against it, not three";
  EXPECT_EQ(alone[0].error, alone[1].error) << "they lie alike to all others";
  bends(0, 1).areEdits = true, bends(1, 2).bend = bends(1, 3).bend = 1.2;
  const auto torn = errorsByBends(four.site, bends, DistinctMaps(bends));
  EXPECT_GT(torn[1].error, 2 * torn[0].error);
  EXPECT_EQ(torn[0].error, alone[0].error);
}

TEST(ErrorsByBends, editsOfTheTruthAreHeldAgainstIt) {
  SiteOfRuns three({0.01, 0.01, 0.01});
  three.site.reference = 2;
  PairBends bends = bendsOf({0.5, 0.1, 0});
  bends(0, 2).areEdits = true;
  const auto errors = errorsByBends(three.site, bends, DistinctMaps(bends));
  EXPECT_NEAR(errors[0].error, 0.5, 0.1);
  EXPECT_EQ(errors[2].error, 0);
}

TEST(ErrorsByBends, ofCopiesAloneThereIsNoErrorButTheyAreSeen) {
  const SiteOfRuns two({0.01, 0.01});
  PairBends bends(2);
  bends(0, 1) = {0, 1, 1000, true};
  for (const MapError& error : errorsByBends(two.site, bends, DistinctMaps(bends))) {
    EXPECT_EQ(error.error, 0);
    EXPECT_EQ(error.seen, 1);
  }
}

TEST(ErrorsByBends, whatNoOtherHasIsNotSeen) {
  const SiteOfRuns three({0.01, 0.02, 0.03});
  PairBends bends = bendsOf({0.1, 0.4, 0.8});
  bends(0, 2) = bends(1, 2) = {};
  const auto errors = errorsByBends(three.site, bends, DistinctMaps(bends));
  EXPECT_GT(errors[0].seen, 0.9);
  EXPECT_EQ(errors[2].seen, 0);
  EXPECT_EQ(errors[2].error, 0);
}

TEST(ErrorsByBends, aReferenceHasNone) {
  SiteOfRuns three({0.01, 0.02, 0.03});
  three.site.reference = 1;
  PairBends bends = bendsOf({0.3, 0, 0.8});
  const auto errors = errorsByBends(three.site, bends, DistinctMaps(bends));
  EXPECT_EQ(errors[1].error, 0);
  EXPECT_GT(errors[1].seen, 0);
  EXPECT_NEAR(errors[0].error, 0.3, 0.1);
  EXPECT_NEAR(errors[2].error, 0.8, 0.2);
}

TEST(SiteErrors, areThoseOfTheConsensusWhereAllRunsHaveScans) {
  SiteOfRuns three({0.01, 0.02, 0.03});
  const PairBends bends = bendsOf({0.1, 0.4, 0.8});
  const DistinctMaps maps(bends);
  Consensus consensus;
  consensus.errors = ById<RunId, MapError>(3);
  for (std::size_t i = 0; i < 3; ++i) {
    consensus.graphRuns.push_back(RunId(i));
    consensus.siteRuns.add(i);
  }
  consensus.errors[RunId(0)].error = 42;
  EXPECT_NE(siteErrors(three.site, MapPairs(3), bends, maps, consensus)[0].error, 42);
  for (std::size_t i = 0; i < 2; ++i) three.runs[i].scans.resize(5);
  EXPECT_NE(siteErrors(three.site, MapPairs(3), bends, maps, consensus)[0].error, 42)
      << "the third has none";
  three.runs[2].scans.resize(5);
  EXPECT_EQ(siteErrors(three.site, MapPairs(3), bends, maps, consensus)[0].error, 42);
}

/** Three grids of two patches, which the others have at the pose of the whole, and so far off. */
struct GridsOfPatches {
  SiteOfRuns three{{0.01, 0.01, 0.01}};
  PairBends bends = bendsOf({0.05, 0.05, 0.05});
  MapPairs pairs{3};

  explicit GridsOfPatches(double off) {
    for (roomgraph::Run& run : three.runs)
      run.map.patches = {{{0, 0}, {0, 1, 2}, {}, {}}, {{10, 0}, {3}, {}, {}}};
    for (const auto& [i, j] : pairs.pairs())
      for (FollowedWalls* way : {&pairs(i, j).bInA, &pairs(i, j).aInB}) {
        way->patches.push_back({0, {}, 3, 0});
        way->patches.push_back({1, {0, i == 0 ? off : 0, 0}, 1, 0});
      }
  }

  double confirmed(std::size_t run) const {
    return siteErrors(three.site, pairs, bends, DistinctMaps(bends), {})[run].confirmed;
  }
};

TEST(SiteErrors, ofAGridOthersConfirmWhatWasFoundWhereItsErrorExplains) {
  EXPECT_EQ(GridsOfPatches(0.1).confirmed(0), 1);
  const GridsOfPatches off(20);
  EXPECT_EQ(off.confirmed(0), 0.75);
  EXPECT_EQ(off.confirmed(1), 1) << "the third one has all of it";
}

TEST(SiteErrors, nothingIsAskedOfTheReference) {
  GridsOfPatches off(20);
  off.three.site.reference = 0;
  EXPECT_EQ(off.confirmed(0), 1);
}

}  // namespace
}  // namespace roomgraph
