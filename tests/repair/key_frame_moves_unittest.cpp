#include "roomgraph/repair/key_frame_moves.h"

#include <gtest/gtest.h>

#include "roomgraph/base/compressed.h"

namespace roomgraph {
namespace {

/** A run of 7 key frames, 1 m from each to the next, with scans at the second and the sixth. */
struct SevenFrames {
  Run run;
  RepairedRun repaired;
  Recording recording;

  SevenFrames() {
    for (int k = 0; k < 7; ++k)
      recording.frames.emplace_back().robot = mrpt::poses::CPose3D(k, 0, 0.3, 0, 0, 0);
    for (const std::size_t k : {1u, 5u}) {
      ScanWalls scan;
      scan.keyFrame = k, scan.pose = {double(k), 0, 0};
      run.scans.push_back(scan);
    }
    repaired.state = RepairState::mended;
    repaired.poses = {{1, 0, 0}, {5, 2, 0}};
  }

  Transform2D movedAt(std::size_t k) const {
    return keyFrameMoves(run, repaired, recording)[k].motion * Transform2D{double(k), 0, 0};
  }
};

TEST(KeyFrameMoves, thoseWithoutAScanGoAlongWithTheirNeighbours) {
  const SevenFrames seven;
  const double expected[] = {0, 0, 0.5, 1, 1.5, 2, 2};
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(seven.movedAt(k).y, expected[k], 1e-12) << k;
    EXPECT_NEAR(seven.movedAt(k).x, double(k), 1e-12) << k;
  }
}

TEST(KeyFrameMoves, thoseWithoutAScanAreAsSureAsTheirNeighboursAre) {
  SevenFrames seven;
  seven.repaired.covariances = {{0.1, 0, 0, 0, 0, 0}, {0.5, 0, 0, 0, 0, 0}};
  const double expected[] = {0.1, 0.1, 0.2, 0.3, 0.4, 0.5, 0.5};
  const std::vector<PoseMove> moves = keyFrameMoves(seven.run, seven.repaired, seven.recording);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(moves[k].covariance->xx, expected[k], 1e-12) << k;
}

TEST(KeyFrameMoves, aRunThatIsLeftAsItWasDoesNotMove) {
  SevenFrames seven;
  seven.repaired.state = RepairState::kept;
  for (const PoseMove& move : keyFrameMoves(seven.run, seven.repaired, seven.recording)) {
    EXPECT_EQ(move.motion.shift(), (Point{0, 0}));
    EXPECT_EQ(move.motion.phi, 0);
    EXPECT_FALSE(move.covariance);
  }
}

TEST(KeyFrameMoves, aMapThatIsGzipSaysWhoHasWrittenIt) {
  EXPECT_NE(packedMap("content", Compression::gzip).find(kGzipMark), std::string::npos);
  EXPECT_EQ(packedMap("content", Compression::none), "content");
}

}  // namespace
}  // namespace roomgraph
