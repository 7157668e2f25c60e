#include <gtest/gtest.h>

#include "TestFolder.h"
#include "roomgraph/graph_files/area_pictures.h"
#include "roomgraph/images/read_labels.h"
#include "sample_stages.h"

namespace roomgraph {
namespace {

LabelMap writtenAndRead(const Stages& stages) {
  const TestFolder folder;
  return readLabels(folder.write("x.png", areaLabelsPng(stages.areas, stages.grid.frame)));
}

TEST(AreaLabelsPng, givesTheLabelsBack) {
  for (const Stages& stages : {sampleStages(), extractedStages()}) {
    const LabelMap map = writtenAndRead(stages);
    ASSERT_EQ(map.width, stages.grid.frame.width);
    ASSERT_EQ(map.height, stages.grid.frame.height);
    ASSERT_EQ(map.label.size(), stages.areas.labels.size());
    for (std::size_t i = 0; i < map.label.size(); ++i)
      ASSERT_EQ(map.label[i], stages.areas.labels[i]) << i;
  }
}

TEST(AreaLabelsPng, hasSixteenBitsOfGreyAndTheHighestRowOnTop) {
  const std::string png = areaLabelsPng({{}, {}, {1, 2, 60000, 4}}, {2, 2, 1, {}});
  // The header: width, height, bits for each sample, kind of colour.
  EXPECT_EQ(png.substr(16, 10), std::string("\0\0\0\2\0\0\0\2\20\0", 10));
  const TestFolder folder;
  EXPECT_EQ(readLabels(folder.write("x.png", png)).label,
            (std::vector<std::uint32_t>{1, 2, 60000, 4}));
}

}  // namespace
}  // namespace roomgraph
