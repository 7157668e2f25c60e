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

TEST(RejoinPieces, aTearIsMendedThatTheScansOfTheRunRefute) {
  // Where the rest of the run lies nobody has been: beside it nothing fits.
  WronglyTorn site;
  const auto there = site.solved.consensus.posesOf(0);
  auto torn = there;
  const Transform2D away{40, 0, 0};
  for (Transform2D& pose : torn) pose = away * pose;
  for (std::size_t k = 0; k < 6; ++k) torn[k] = there[k];
  const auto rejoined = rejoinPieces(site.solved, torn, 0);
  const Transform2D frame = rejoined[10] * there[10].inverse();
  for (std::size_t k = 0; k < there.size(); ++k)
    EXPECT_LT(poseDistance(rejoined[k], frame * there[k]), 0.1) << k;
}

TEST(RejoinPieces, aRunThatIsReallyTornStaysMended) {
  const test::SolvedDrives& site = test::tornAmongSound();
  for (std::size_t run = 0; run < 3; ++run)
    for (std::size_t k = 0; k < site.real[run].size(); ++k)
      EXPECT_EQ(site.real[run][k].shift(), site.solved.consensus.posesOf(run)[k].shift());
}

}  // namespace
}  // namespace roomgraph
