#include "roomgraph/repair/rejoin_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "repaired_site.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

/** Three sound drives, in whose consensus the first scans of the first lie elsewhere. */
struct WronglyTorn {
  std::vector<Run> runs = test::SolvedDrives::runsOf(
      {test::drive(1), test::drifting(test::drive(2), 0.0003), test::drive(3)});
  SolvedSite solved = solveSite(runs, test::related(runs), {}, oneByOne);
};

TEST(RejoinPieces, aTearThatNothingBearsOutIsMended) {
  WronglyTorn site;
  const auto sound = rejoinPieces(site.solved)[0];
  auto torn = sound;
  for (std::size_t k = 0; k < 6; ++k) torn[k] = Transform2D{9, 4, M_PI} * torn[k];
  const auto rejoined = rejoinPieces(site.solved, torn, 0);
  for (std::size_t k = 0; k < sound.size(); ++k)
    EXPECT_LT(poseDistance(rejoined[k], sound[k]), 0.1) << k;
}

TEST(RejoinPieces, aRunThatIsReallyTornStaysMended) {
  const test::SolvedDrives& site = test::tornAmongSound();
  for (std::size_t run = 0; run < 3; ++run)
    for (std::size_t k = 0; k < site.real[run].size(); ++k)
      EXPECT_EQ(site.real[run][k].shift(), site.solved.posesOf(run)[k].shift());
}

}  // namespace
}  // namespace roomgraph
