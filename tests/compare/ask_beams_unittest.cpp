#include "ask_beams.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

/** Runs of one building, the last of which has laid its way back over other rooms. */
class AskBeams : public testing::Test {
 protected:
  AskBeams() {
    for (int i = 0; i < 2; ++i) runs_.push_back(test::runOf(test::driveForthAndBack()));
    runs_.push_back(test::runOf(test::broken(test::driveForthAndBack(), 50, 0, {0.5, 1.5})));
  }

  /** The score of the last run, of which this was reported, if the consensus has it at `poses`. */
  RunScore asked(double error, const std::vector<Transform2D>& poses) {
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
    RunScores scores(runs_.size(), RunScore());
    for (auto& score : scores) score->mapError = error, score->isMeaningful = true;
    askBeams(site, consensus, scores, oneByOne);
    EXPECT_TRUE(scores[0]->isMeaningful);
    return *scores.back();
  }

  std::vector<Transform2D> drawn() const { return drawnPoses(runs_.back().scans); }

  std::vector<roomgraph::Run> runs_;
};

TEST_F(AskBeams, aRunThatSeesThroughItsOwnWallsHasNoMeaningfulError) {
  const RunScore score = asked(0.1, drawn());
  EXPECT_FALSE(score.isMeaningful);
  ASSERT_TRUE(score.welded);
  EXPECT_LT(score.welded->first, 50u);
  EXPECT_GE(score.welded->second, 50u);
}

TEST_F(AskBeams, notIfTheConsensusHasPartedWhatItLaidThere) {
  EXPECT_TRUE(asked(0.1, drawnPoses(runs_[0].scans)).isMeaningful);
}

TEST_F(AskBeams, norIfItsErrorIsReportedAsLarge) { EXPECT_TRUE(asked(1, drawn()).isMeaningful); }

TEST_F(AskBeams, norIfAllSeeThroughWalls) {
  runs_.front() = runs_.back();
  const RunScore score = asked(0.1, drawn());
  EXPECT_TRUE(score.isMeaningful);
  EXPECT_FALSE(score.welded);
}

}  // namespace
}  // namespace roomgraph
