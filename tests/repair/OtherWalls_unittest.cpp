#include "OtherWalls.h"

#include <gtest/gtest.h>

#include "repaired_site.h"

namespace roomgraph {
namespace {

TEST(OtherWalls, aScanFitsWhereItReallyLies) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const std::vector<LocalScan> scans = localScans(site.runs[1].scans);
  for (const std::size_t k : {5, 15, 25}) {
    const Transform2D real = site.real[1][k];
    const OtherWalls walls(site.solved, 1, {real.shift()});
    const double there = walls.at(scans[k], real).score;
    EXPECT_GT(there, 20) << k;
    EXPECT_LT(walls.at(scans[k], real * Transform2D{0.4, 0.5, 0.3}).score, there / 2) << k;
    EXPECT_GE(walls.near(scans[k], real * Transform2D{0.05, 0.1, 0.02}).score, 0.8 * there) << k;
  }
}

TEST(OtherWalls, whereNobodyHasBeenNothingSpeaksForAPose) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const LocalScan scan = localScans(site.runs[1].scans)[5];
  const OtherWalls walls(site.solved, 1, {{500, 0}});
  EXPECT_EQ(walls.at(scan, {500, 0, 0}).score, 0);
  EXPECT_EQ(walls.near(scan, {500, 0, 0}).score, 0);
}

}  // namespace
}  // namespace roomgraph
