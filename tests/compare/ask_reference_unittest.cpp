#include "ask_reference.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

/** A run beside a reference that lies elsewhere in the frame of the site. */
class AskReference : public testing::Test {
 protected:
  ReferenceFaults askAbout(const std::vector<Keyframe>& frames) {
    reference_ = test::runOf(frames);
    Site site;
    site.runs = {&run_, &reference_}, site.poses = {{}, {3, 4, M_PI / 2}}, site.reference = 1;
    scores_ = {RunScore(), std::nullopt};
    scores_[0]->isMeaningful = true;
    return askReference(site, scores_);
  }

  roomgraph::Run run_, reference_;
  RunScores scores_;
};

TEST_F(AskReference, aSoundOneLeavesAllScoresMeaningful) {
  const ReferenceFaults faults = askAbout(test::driveForthAndBack());
  EXPECT_TRUE(faults.breaks.empty());
  EXPECT_EQ(faults.doubled, 0);
  EXPECT_TRUE(scores_[0]->isMeaningful);
}

TEST_F(AskReference, nobodyIsMeasuredByABrokenOne) {
  const auto frames = test::broken(test::driveForthAndBack(), 50, 1.6, {1, 2});
  const std::vector<MapBreak> breaks = askAbout(frames).breaks;
  ASSERT_EQ(breaks.size(), 1u);
  EXPECT_EQ(breaks[0].keyFrame, 50u);
  const Point drawn = Transform2D{3, 4, M_PI / 2}(frames[49].pose.shift());
  EXPECT_LT(distance(breaks[0].place, drawn), 1e-9) << "in the frame of the site";
  EXPECT_FALSE(scores_[0]->isMeaningful);
  EXPECT_FALSE(scores_[1]);
}

TEST_F(AskReference, norByOneThatHasDrawnItsRoomsTwice) {
  const ReferenceFaults faults = askAbout(test::drifting(test::driveForthAndBack(), 0.005));
  EXPECT_TRUE(faults.breaks.empty());
  EXPECT_GT(faults.doubled, 0.5);
  EXPECT_FALSE(scores_[0]->isMeaningful);
}

TEST_F(AskReference, oneWithoutScansTellsNothing) {
  EXPECT_TRUE(askAbout({}).breaks.empty());
  EXPECT_TRUE(scores_[0]->isMeaningful);
}

}  // namespace
}  // namespace roomgraph
