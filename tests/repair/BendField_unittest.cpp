#include "roomgraph/repair/BendField.h"

#include <gtest/gtest.h>

#include "repaired_site.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

/** A place beside each scan of the true drive, as a run has drawn it: by that scan. */
Transform2D besideScan(const Run& run, std::size_t k) {
  return run.scans[k].pose * Transform2D{0.3, 0.2, 0.5};
}

TEST(BendField, goesToTheSiteAndBack) {
  const test::SolvedDrives& site = test::tornAmongSound();
  for (std::size_t run = 0; run < 3; ++run) {
    const BendField there(site.solved, site.real, run, BendField::Way::toSite);
    const BendField back(site.solved, site.real, run, BendField::Way::toRun);
    for (std::size_t k = 0; k < site.runs[run].scans.size(); k += 7) {
      const Transform2D place = besideScan(site.runs[run], k);
      const auto in = there(place);
      ASSERT_TRUE(in);
      EXPECT_TRUE(in->isSeen);
      EXPECT_TRUE(in->isKnown);
      const auto again = back(in->pose);
      ASSERT_TRUE(again);
      EXPECT_LT(poseDistance(again->pose, place), 0.15) << run << " " << k;
    }
  }
}

TEST(BendField, onlyATornRunHasAPlaceTwice) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const auto isTwice = [&](std::size_t run, std::size_t scan) {
    const BendField there(site.solved, site.real, run, BendField::Way::toSite);
    return there(besideScan(site.runs[run], scan))->rival > BendField::kSameCopy;
  };
  for (std::size_t k = 0; k < site.runs[0].scans.size(); ++k) EXPECT_FALSE(isTwice(0, k)) << k;
  EXPECT_TRUE(isTwice(1, 19)) << "just before the break";
  EXPECT_TRUE(isTwice(1, 20)) << "and just behind it";
  EXPECT_FALSE(isTwice(1, 2)) << "far from it";
}

TEST(BendField, placesBehindWallsAreKnownWhereTheKeyFramesAre) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const BendField there(site.solved, site.real, 0, BendField::Way::toSite);
  std::size_t behind = 0;
  for (const ScanWalls& scan : site.runs[0].scans)
    if (const auto carried = there(scan.pose * Transform2D{0, 4, 0}); carried && !carried->isSeen) {
      ++behind;
      EXPECT_TRUE(carried->isKnown);
    }
  EXPECT_GE(behind, 3u);
}

TEST(BendField, tellsNothingOfWhatIsFarAway) {
  const test::SolvedDrives& site = test::tornAmongSound();
  EXPECT_FALSE(BendField(site.solved, site.real, 0, BendField::Way::toSite)({500, 0, 0}));
}

TEST(BendField, wallsCarryWhereThereAreNoScans) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const BendField field(site.solved, 0, 2);
  const std::size_t middle = site.runs[0].scans.size() / 2;
  const auto carried = field(besideScan(site.runs[0], middle));
  ASSERT_TRUE(carried);
  EXPECT_LT(poseDistance(carried->pose, besideScan(site.runs[2], middle)), 0.2);
}

TEST(BendField, aMapWithoutScansCarriesPlacesToItself) {
  const test::SolvedDrives& site = test::tornAmongSound();
  const Transform2D place = besideScan(site.runs[0], 5);
  const auto carried = BendField(site.solved, 0, 0)(place);
  ASSERT_TRUE(carried);
  EXPECT_LT(poseDistance(carried->pose, place), 1e-9);
  EXPECT_LT(carried->rival + carried->spread, 1e-9);
}

/** All of them once more, 20 m beside, with fewer walls, as one more search has found them. */
void addElsewhere(std::vector<FollowedPatch>& patches, int layer) {
  std::vector<FollowedPatch> elsewhere = patches;
  for (FollowedPatch& patch : elsewhere)
    patch.pose.x += 20, patch.layer = layer, patch.walls *= 0.4;
  patches.insert(patches.end(), elsewhere.begin(), elsewhere.end());
}

TEST(BendField, aSmallPieceThatLiesElsewhereIsNotBelieved) {
  test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  const Transform2D place = besideScan(site.runs[0], site.runs[0].scans.size() / 2);
  const auto before = BendField(site.solved, 0, 2)(place);
  std::vector<FollowedPatch>& patches = site.solved.pairs(0, 2).aInB.patches;
  const std::size_t count = patches.size();
  addElsewhere(patches, 99);
  const auto after = BendField(site.solved, 0, 2)(place);
  ASSERT_TRUE(before && after);
  EXPECT_LT(poseDistance(after->pose, before->pose), 1e-9);
  EXPECT_LT(after->rival, BendField::kSameCopy);
  for (std::size_t i = count; i < 2 * count; ++i) patches[i].walls *= 2;
  EXPECT_GT(BendField(site.solved, 0, 2)(place)->rival, BendField::kSameCopy) << "a torn map";
}

TEST(BendField, wallsFoundInOneSearchAreJudgedPieceByPiece) {
  test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  const Transform2D place = besideScan(site.runs[0], site.runs[0].scans.size() / 2);
  const auto before = BendField(site.solved, 0, 2)(place);
  std::vector<FollowedPatch>& patches = site.solved.pairs(0, 2).aInB.patches;
  for (std::size_t i = 1; i < patches.size(); i += 2) patches[i].layer = 5;
  addElsewhere(patches, 5);
  const auto after = BendField(site.solved, 0, 2)(place);
  ASSERT_TRUE(before && after);
  EXPECT_LT(poseDistance(after->pose, before->pose), 1e-9);
  EXPECT_LT(after->rival, BendField::kSameCopy);
}

TEST(BendField, aPlaceThatTheOtherMapHasTwiceIsToldByTheWayBack) {
  test::SolvedDrives site({test::drive(1), test::drive(2), test::drive(3)});
  const Transform2D place = besideScan(site.runs[0], site.runs[0].scans.size() / 2);
  const auto before = BendField(site.solved, 0, 2)(place);
  for (FollowedPatch& patch : site.solved.pairs(0, 2).bInA.patches) patch.pose.x += 1.9;
  const auto after = BendField(site.solved, 0, 2)(place);
  ASSERT_TRUE(before && after);
  EXPECT_LT(before->rival, BendField::kSameCopy);
  EXPECT_NEAR(after->rival, 1.9, 0.3);
  EXPECT_EQ(poseDistance(after->pose, before->pose), 0);
}

}  // namespace
}  // namespace roomgraph
