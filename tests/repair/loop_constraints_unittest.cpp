#include "roomgraph/repair/loop_constraints.h"

#include <gtest/gtest.h>

#include <cmath>

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
  const auto constraints = loopConstraints(drifted(real), real);
  ASSERT_EQ(constraints.size(), 80u);
  for (const LoopConstraint& one : constraints) {
    EXPECT_EQ(one.to, one.from + 80);
    EXPECT_EQ(one.fromTime, 1e9 + double(one.from));
    EXPECT_NEAR(one.sigma, 0.03, 1e-9);
  }
}

TEST(LoopConstraints, noneWithoutTimesOrLoops) {
  auto real = twiceRound();
  roomgraph::Run run = drifted(real);
  for (ScanWalls& scan : run.scans) scan.time.reset();
  EXPECT_TRUE(loopConstraints(run, real).empty());
  real.resize(80);
  run = drifted(real);
  EXPECT_LE(loopConstraints(run, real).size(), 1u) << "at most where it ends";
}

TEST(LoopConstraints, areWrittenAsMolaReadsThem) {
  EXPECT_EQ(molaConstraints({{0, 9, 1e9, 1e9 + 9.5, 0.25}}),
            "manual_loop_constraints:\n  - {timestamp_i: 1000000000.000000, timestamp_j: "
            "1000000009.500000, sigma_xyz: 0.250, trust_as_inlier: true}\n");
  EXPECT_EQ(molaConstraints({}), "manual_loop_constraints: []\n");
}

}  // namespace
}  // namespace roomgraph
