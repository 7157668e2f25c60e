#include "roomgraph/drawing/draw_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "TestFolder.h"
#include "png_pixels.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "sample_stages.h"

namespace roomgraph {
namespace {

using Json = nlohmann::json;

void writeStages(const Stages& stages, const std::string& folder) {
  StagedFiles files;
  drawStages(stages, folder, files);
  files.commit();
}

TEST(DrawStages, writesOnePictureForEachStepAndTheCounts) {
  const TestFolder folder;
  const Stages stages = extractedStages();
  writeStages(stages, folder / "stages");
  const Json json = Json::parse(readAll(folder / "stages/stages.json"));
  EXPECT_EQ(json["format"], "roomgraph/stages");
  ASSERT_EQ(json["stages"].size(), 16u);
  for (const Json& stage : json["stages"]) {
    SCOPED_TRACE(stage["file"].get<std::string>());
    EXPECT_GT(decodePng(readAll(folder / ("stages/" + stage["file"].get<std::string>()))).width, 0);
    EXPECT_FALSE(stage["counts"].empty());
  }
  EXPECT_EQ(json["stages"][0]["file"], "01_grid.png");
  EXPECT_EQ(json["stages"][1]["counts"]["obstacle_cells"], stages.obstacles.cells.size());
  EXPECT_EQ(json["stages"][4]["counts"]["edges"], stages.clearEdges.size());
  EXPECT_EQ(json["stages"][8]["counts"]["vertices"], stages.kept.vertices().size());
  EXPECT_EQ(json["stages"][14]["counts"]["rooms"], stages.result.rooms.size());
  EXPECT_EQ(json["stages"][15]["file"], "16_areas.png");
  EXPECT_EQ(json["stages"][15]["counts"]["rooms"], stages.result.rooms.size());
  EXPECT_EQ(json["stages"][15]["counts"]["passages"], stages.areas.passages.size());
  EXPECT_EQ(json["stages"][15]["counts"]["clutter"], 1);
}

TEST(DrawStages, ofAnEmptyMapAreWritten) {
  const TestFolder folder;
  Stages stages;
  stages.grid = {{3, 3, 0.05, {}}, std::vector<State>(9, State::unknown)};
  writeStages(stages, folder.path());
  std::vector<std::string> names = stageFiles();
  std::sort(names.begin(), names.end());
  EXPECT_EQ(folder.names(), names);
  EXPECT_EQ(names.size(), 17u);
}

TEST(DrawStages, aFileInTheWayIsAnError) {
  const TestFolder folder;
  writeFileAtomically(folder / "file", "text");
  EXPECT_THROW(writeStages(sampleStages(), folder / "file"), DataError);
  EXPECT_EQ(readAll(folder / "file"), "text");
}

}  // namespace
}  // namespace roomgraph
