#include <gtest/gtest.h>

#include <cmath>

#include "TestFolder.h"
#include "roomgraph/graph_files/area_pictures.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/map_files/load_grid.h"
#include "sample_stages.h"

namespace roomgraph {
namespace {

/** A mask as nav2 loads it in the mode of its yaml: 0 to 100, row-major, row 0 lowest. */
std::vector<double> loaded(const std::string& png, const GridFrame& frame, RosMapMode mode) {
  const TestFolder folder;
  folder.write("mask.png", png);
  const GreyMap map =
      loadGrid(folder.write("mask.yaml", rosMapYaml(frame, "mask.png", {}, mode)), {});
  EXPECT_EQ(map.frame.width, frame.width);
  EXPECT_EQ(map.frame.height, frame.height);
  EXPECT_NEAR(map.frame.origin.x, frame.origin.x, 1e-6);
  std::vector<double> values;
  for (const std::uint8_t grey : map.grey) {
    const double occupancy = (255 - grey) / 255.0;
    values.push_back(mode == RosMapMode::scale ? std::rint(100 * occupancy)
                     : occupancy > 0.65        ? 100
                     : occupancy < 0.196       ? 0
                                               : -1);
  }
  return values;
}

TEST(Nav2Masks, keepoutHasTheCellsOfTheRoomsAndNoOthers) {
  const Stages stages = extractedStages();
  const std::vector<double> mask =
      loaded(keepoutMaskPng(stages.areas, stages.grid.frame, {RoomId(1)}), stages.grid.frame,
             RosMapMode::trinary);
  ASSERT_EQ(mask.size(), stages.areas.labels.size());
  std::size_t keptOut = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const std::uint16_t label = stages.areas.labels[i];
    const bool isInRoom = label > 0 && stages.areas.areas[label - 1].room == RoomId(1);
    ASSERT_EQ(mask[i], isInRoom ? 100 : 0) << i;
    keptOut += isInRoom;
  }
  EXPECT_GT(keptOut, 1000u);
}

TEST(Nav2Masks, withoutRoomsNothingIsKeptOut) {
  const Stages stages = sampleStages();
  for (const double value : loaded(keepoutMaskPng(stages.areas, stages.grid.frame, {}),
                                   stages.grid.frame, RosMapMode::trinary))
    ASSERT_EQ(value, 0);
}

TEST(Nav2Masks, speedIsCutNearNarrowPassagesAlone) {
  const Stages stages = extractedStages();
  const GridFrame& frame = stages.grid.frame;
  const std::vector<double> mask =
      loaded(speedMaskPng(stages.areas, frame), frame, RosMapMode::scale);
  ASSERT_FALSE(stages.areas.passages.empty());
  const Passage& passage = stages.areas.passages.front();
  ASSERT_LT(passage.width, 2);
  EXPECT_NEAR(mask[frame.index(frame.cellAt(passage.middle()))], 100 - 50 * passage.width, 1);
  const Point room = stages.areas.areas.front().widestPlace;
  ASSERT_GT(distance(room, passage.middle()), 1 + passage.width / 2);
  EXPECT_EQ(mask[frame.index(frame.cellAt(room))], 0);
}

TEST(Nav2Masks, whereTwoPassagesAreNearTheNarrowerCounts) {
  AreaGraph areas;
  areas.passages = {{AreaId(0), AreaId(1), {1, 1}, {1, 1.8}, 0.8},
                    {AreaId(0), AreaId(1), {1.2, 1}, {1.2, 1.6}, 0.6},
                    {AreaId(0), AreaId(1), {1.4, 1}, {1.4, 4}, 3}};
  const GridFrame frame{50, 50, 0.1, {0, 0}};
  const std::vector<double> mask = loaded(speedMaskPng(areas, frame), frame, RosMapMode::scale);
  EXPECT_EQ(mask[frame.index(frame.cellAt({1.2, 1.3}))], 70);
  EXPECT_EQ(mask[frame.index(frame.cellAt({1.4, 3.5}))], 0);  // wide enough
}

}  // namespace
}  // namespace roomgraph
