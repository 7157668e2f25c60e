#include "roomgraph/check/find_refuted.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

/** Runs of one building, the last of which has laid its way back over other rooms. */
class FindRefuted : public testing::Test {
 protected:
  FindRefuted() {
    for (int i = 0; i < 2; ++i) runs_.push_back(test::runOf(test::driveForthAndBack()));
    runs_.push_back(test::runOf(test::broken(test::driveForthAndBack(), 50, 0, {0.5, 1.5})));
  }

  /** What the last run has welded, of which this error was reported, if it lies at `poses`. */
  WeldedKeyFrames asked(double error, const std::vector<Transform2D>& poses, double high = 0) {
    Site site;
    Consensus consensus;
    for (const roomgraph::Run& run : runs_) {
      const bool isLast = &run == &runs_.back();
      const RunId id = consensus.graph.addRun(true);
      for (std::size_t k = 0; k < run.scans.size(); ++k) {
        const ScanWalls& scan = run.scans[k];
        consensus.graph.addNode(scan.pose, scan.ends, scan.axes);
        consensus.poses.add(isLast ? poses[k] : scan.pose);
      }
      consensus.siteRuns.add(site.runs.size());
      consensus.graphRuns.push_back(id);
      site.runs.push_back(&run);
    }
    site.runs.push_back(&runs_.back());  // a copy, for which the last one counts
    consensus.graphRuns.push_back(consensus.graphRuns.back());
    consensus.errors = ById<RunId, MapError>(runs_.size());
    for (MapError& of : consensus.errors) of.error = error, of.high = high;
    const auto refuted = findRefuted(site, consensus, oneByOne);
    EXPECT_FALSE(refuted[0]);
    EXPECT_EQ(refuted[2], refuted[3]);
    return refuted.back();
  }

  std::vector<Transform2D> drawn() const { return drawnPoses(runs_.back().scans); }

  std::vector<roomgraph::Run> runs_;
};

TEST_F(FindRefuted, tellsARunThatSeesThroughItsOwnWalls) {
  const WeldedKeyFrames welded = asked(0.1, drawn());
  ASSERT_TRUE(welded);
  EXPECT_LT(welded->first, 50u);
  EXPECT_GE(welded->second, 50u);
}

TEST_F(FindRefuted, notIfTheConsensusHasPartedWhatItLaidThere) {
  EXPECT_FALSE(asked(0.1, drawnPoses(runs_[0].scans)));
}

TEST_F(FindRefuted, norIfItsErrorSaysThatItIsWrong) {
  EXPECT_FALSE(asked(1, drawn(), 1.1));
  EXPECT_TRUE(asked(1, drawn(), 1.3)) << "it may be apart";
  EXPECT_FALSE(asked(1.3, drawn(), 2));
}

TEST_F(FindRefuted, norWithoutOthersToHoldItAgainst) {
  for (roomgraph::Run& run : runs_)
    if (&run != &runs_.back()) run.scans.clear();
  EXPECT_FALSE(asked(0.1, drawn()));
}

TEST_F(FindRefuted, norIfAllSeeThroughWalls) {
  runs_.front() = runs_.back();
  EXPECT_FALSE(asked(0.1, drawn()));
}

}  // namespace
}  // namespace roomgraph
