#include "roomgraph/consensus/agreed_bends.h"

#include <gtest/gtest.h>

#include "drawn_pose_graph.h"

namespace roomgraph {
namespace {

using test::Way;

/** Two runs, the first of them torn, of which a consensus knows where they lie. */
struct TornAndWhole {
  Way truth = test::roundTheBlock(), torn = test::torn(truth, 20, 1.5, {3, 4});
  std::vector<roomgraph::Run> runs;
  Site site;
  Consensus consensus;
  PairBends bends{2, {{0, 1}}};

  TornAndWhole() {
    for (int i = 0; i < 2; ++i) runs.emplace_back().scans.resize(1);
    for (const roomgraph::Run& run : runs) site.runs.push_back(&run);
    consensus.graph = test::matchedPoseGraph({torn, truth}, {truth, truth});
    consensus.poses = test::posesOf({truth, truth});
    consensus.graphRuns = {RunId(0), RunId(1)};
    believe(1);
    bends(0, 1) = {7, 0.5, 1000};
  }

  void believe(double belief) {
    consensus.trust.belief = ById<MatchGroupId, double>(consensus.graph.groups.size(), belief);
  }
  double bend() const { return agreedBends(site, consensus, bends)(0, 1).bend; }
};

TEST(AgreedBends, areHowFarTheOneHasDrawnWhatTheOtherHas) {
  const TornAndWhole site;
  EXPECT_NEAR(site.bend(), test::displacement(site.torn, site.truth), 1e-6);
  EXPECT_EQ(agreedBends(site.site, site.consensus, site.bends)(0, 1).share, 0.5);
}

TEST(AgreedBends, areNoneWhereBothAreRight) {
  TornAndWhole site;
  site.consensus.graph = test::matchedPoseGraph({site.truth, site.truth}, {site.truth, site.truth});
  site.believe(1);
  EXPECT_NEAR(site.bend(), 0, 1e-6);
}

TEST(AgreedBends, stayThoseOfTheWallsWithoutScansOrBelief) {
  TornAndWhole site;
  site.believe(0);
  EXPECT_EQ(site.bend(), 7);
  site.believe(1);
  site.runs[1].scans.clear();
  EXPECT_EQ(site.bend(), 7);
}

TEST(AgreedBends, ofCopiesStay) {
  TornAndWhole site;
  site.consensus.graphRuns[1] = RunId(0);
  EXPECT_EQ(site.bend(), 7);
}

}  // namespace
}  // namespace roomgraph
