#include "roomgraph/breaks/frames_at_break.h"

#include <gtest/gtest.h>

#include "roomgraph/align/scan_walls.h"

namespace roomgraph {
namespace {

MapBreak tearAt(std::optional<std::size_t> frame) {
  MapBreak tear;
  tear.keyFrame = frame;
  return tear;
}

std::vector<ScanWalls> scansOf(std::size_t count) {
  std::vector<ScanWalls> scans(count);
  for (std::size_t k = 0; k < count; ++k) scans[k].keyFrame = k;
  return scans;
}

TEST(FramesAtBreak, areFoundByTheirNumbersInTheFile) {
  std::vector<ScanWalls> scans = scansOf(30);
  for (ScanWalls& scan : scans) scan.keyFrame *= 3;  // two of three key frames have no scan
  const FramesAtBreak frames = framesAtBreak(tearAt(34), scans);
  EXPECT_EQ(frames.first, 2u);
  EXPECT_EQ(frames.behind, 12u);
  EXPECT_EQ(frames.end, 22u);
}

TEST(FramesAtBreak, areTenOnEitherSideWhereThereAreAsMany) {
  const auto at = [](std::optional<std::size_t> frame, std::size_t count) {
    const FramesAtBreak frames = framesAtBreak(tearAt(frame), scansOf(count));
    return std::make_pair(frames.first, frames.end);
  };
  EXPECT_EQ(at(12, 30), std::make_pair(std::size_t(2), std::size_t(22)));
  EXPECT_EQ(at(3, 8), std::make_pair(std::size_t(0), std::size_t(8)));
  EXPECT_EQ(at(std::nullopt, 30), std::make_pair(std::size_t(0), std::size_t(0)));
  EXPECT_EQ(at(30, 30), std::make_pair(std::size_t(0), std::size_t(0)));
}

}  // namespace
}  // namespace roomgraph
