#include "draw_stage.h"

#include <gtest/gtest.h>

#include <set>

#include "roomgraph/drawing/stage_names.h"
#include "sample_view.h"

namespace roomgraph {
namespace {

using test::viewOfMap;

TEST(DrawStage, eachStageIsDrawnAndCounted) {
  const View view = viewOfMap();
  std::set<std::string> lines;
  for (std::size_t stage = 0; stage < stageNames().size(); ++stage) {
    EXPECT_EQ(drawStage(*view.stages, stage)->empty(), stage == 0) << "the grid is the map itself";
    lines.insert(stageLine(*view.stages, stage));
  }
  EXPECT_EQ(lines.size(), 16u);
  EXPECT_EQ(stageLine(*view.stages, 9),
            "stage 10 of 16 (III-B): rooms, the inner polygons of the alpha shape; 2 rooms");
}

}  // namespace
}  // namespace roomgraph
