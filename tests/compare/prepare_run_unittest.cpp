#include "roomgraph/compare/prepare_run.h"

#include <gtest/gtest.h>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "refusal.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph {
namespace {

/** The map as one that was read from a file. */
GreyMap mapOf(const Grid& grid) {
  GreyMap map;
  map.frame = grid.frame;
  map.source = {"somewhere/monday.pgm", "image", "abc", ""};
  for (const State state : grid.cells)
    map.grey.push_back(state == State::free ? 255 : state == State::occupied ? 0 : 127);
  return map;
}

TEST(PrepareRun, aRunHasWhatItsMapTells) {
  const GreyMap map = mapOf(test::drawnBuilding(1, {}));
  const roomgraph::Run run = prepareRun("monday", map, {}, {});
  EXPECT_EQ(run.name, "monday");
  EXPECT_EQ(run.file, "somewhere/monday.pgm");
  EXPECT_EQ(run.sha256, "abc");
  EXPECT_EQ(run.resolution, 0.05);
  EXPECT_FALSE(run.isScaleEstimated);
  EXPECT_TRUE(run.scans.empty());

  const Stages stages = extract(map, {});
  EXPECT_GT(run.rooms.size(), 5u);
  EXPECT_EQ(run.rooms.size(), stages.result.rooms.size());
  EXPECT_EQ(run.graph.vertices().size(), stages.result.graph.vertices().size());
  EXPECT_EQ(run.areas.areas.size(), stages.areas.areas.size());
  EXPECT_EQ(run.map.walls.size(), wallMap(stages.grid).walls.size());
}

TEST(PrepareRun, scansBecomeWallsUnderTheNumbersOfTheirKeyFrames) {
  const Grid grid = test::drawnBuilding(1, {});
  std::vector<Keyframe> frames = test::drawnDrive(grid);
  frames.erase(frames.begin());
  const roomgraph::Run run = prepareRun("monday", mapOf(grid), frames, {});
  ASSERT_EQ(run.scans.size(), frames.size());
  EXPECT_EQ(run.scans.front().keyFrame, 1u);
  EXPECT_FALSE(run.scans.front().walls.empty());
}

TEST(PrepareRun, aMapWithoutWallsIsRefusedByTheNameOfItsFile) {
  Grid empty;
  empty.frame = {20, 20, 0.05, {}};
  for (const State state : {State::free, State::unknown, State::occupied}) {
    empty.cells.assign(empty.frame.cellCount(), state);
    EXPECT_EQ(test::refusalOf([&] { prepareRun("monday", mapOf(empty), {}, {}); }),
              "somewhere/monday.pgm: has no wall beside free space: a run must have some");
  }
}

}  // namespace
}  // namespace roomgraph
