#include "roomgraph/repair/loop_constraints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "occurrences.h"

namespace roomgraph {
namespace {

/** A square of 10 m, driven round twice, half a metre from key frame to key frame. */
std::vector<Transform2D> twiceRound() {
  std::vector<Transform2D> poses;
  for (int k = 0; k < 160; ++k) {
    const int side = k / 20 % 4;
    const Transform2D corner{side == 1 || side == 2 ? 10.0 : 0.0, side >= 2 ? 10.0 : 0.0,
                             side * M_PI / 2};
    poses.push_back(corner * Transform2D{0.5 * (k % 20), 0, 0});
  }
  return poses;
}

/** The same with a heading that drifts. */
Run drifted(const std::vector<Transform2D>& real) {
  Run run;
  Transform2D at = real.front();
  for (std::size_t k = 0; k < real.size(); ++k) {
    if (k > 0) at = at * real[k - 1].inverse() * real[k] * Transform2D{0, 0, 0.004};
    ScanWalls scan;
    scan.pose = at, scan.keyFrame = k, scan.time = 1e9 + double(k);
    run.scans.push_back(scan);
  }
  return run;
}

TEST(LoopConstraints, areWhereThePathReallyComesBack) {
  const auto real = twiceRound();
  std::string text = "manual_loop_constraints:\n";
  for (int k = 0; k < 80; ++k)
    text += "  - {timestamp_i: " + std::to_string(1e9 + k) +
            ", timestamp_j: " + std::to_string(1e9 + k + 80) +
            ", sigma_xyz: 0.030, trust_as_inlier: true}\n";
  EXPECT_EQ(molaConstraints(drifted(real), real), text);
}

TEST(LoopConstraints, noneWithoutTimesOrLoops) {
  auto real = twiceRound();
  roomgraph::Run run = drifted(real);
  for (ScanWalls& scan : run.scans) scan.time.reset();
  EXPECT_EQ(molaConstraints(run, real), "manual_loop_constraints: []\n");
  for (ScanWalls& scan : run.scans) scan.time = 1e9;
  EXPECT_EQ(molaConstraints(run, real), "manual_loop_constraints: []\n")
      << "no key frame is found by a time that all have";
  real.resize(80);
  run = drifted(real);
  EXPECT_LE(test::count(molaConstraints(run, real), "timestamp_i"), 1u) << "at most where it ends";
}

TEST(LoopConstraints, aTimeIsOfOneKeyFrame) {
  roomgraph::Run run = drifted(twiceRound());
  run.scans.resize(5);
  run.scans[1].keyFrame = 0, run.scans[1].time = run.scans[0].time;  // two scanners
  run.scans[3].time = run.scans[2].time;
  run.scans[4].time.reset();
  EXPECT_EQ(haveOwnTimes(run.scans), (std::vector<bool>{true, true, false, false, false}));
}

}  // namespace
}  // namespace roomgraph
