#include "roomgraph/mrpt_plugin/map_comparison_file.h"

#include <gtest/gtest.h>
#include <mrpt/io/zip.h>

#include <string>

#include "TestFolder.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "sample_graph.h"
#include "sample_map_comparison.h"

namespace roomgraph {
namespace {

std::string messageOf(const std::string& file) {
  return test::refusalOf([&] { loadMapComparison(file); });
}

TEST(MapComparisonFile, comesBackAsItWas) {
  const TestFolder folder;
  const CMapComparison sample = test::sampleMapComparison();
  const std::string file = folder.write("comparison.roomgraph", mapComparisonBytes(sample));
  const CMapComparison back = loadMapComparison(file);
  EXPECT_EQ(mapComparisonBytes(back), mapComparisonBytes(sample));
  EXPECT_EQ(back.asString(), sample.asString());
  ASSERT_EQ(back.walls.size(), 2u);
  EXPECT_EQ(back.walls.begin()->first, "good");
  EXPECT_NEAR(back.walls.at("torn")[7].x, sample.walls.at("torn")[7].x, 1e-6);
}

TEST(MapComparisonFile, anotherObjectIsRefusedInOneLine) {
  const TestFolder folder;
  const std::string graph = folder.write("a.roomgraph", roomGraphBytes(sampleGraph()));
  EXPECT_EQ(messageOf(graph), graph + ": is not a comparison of maps: give a comparison.roomgraph");
  const std::string comparison =
      folder.write("b.roomgraph", mapComparisonBytes(test::sampleMapComparison()));
  EXPECT_THROW(loadRoomGraph(comparison), DataError);
}

TEST(MapComparisonFile, noDamageIsTakenForAComparison) {
  const TestFolder folder;
  const std::string whole = mapComparisonBytes(test::sampleMapComparison());
  std::vector<std::uint8_t> plain;
  mrpt::io::zip::decompress_gz_data_block({whole.begin(), whole.end()}, plain);
  for (const std::size_t end : {plain.size() - 1, plain.size() / 2, plain.size() - 8 * 100}) {
    const std::string cut(plain.begin(), plain.begin() + std::ptrdiff_t(end));
    EXPECT_NE(messageOf(folder.write("cut.roomgraph", cut)), "") << end;
  }
  std::string more(plain.begin(), plain.end());
  more += "x";
  EXPECT_NE(messageOf(folder.write("more.roomgraph", more)).find("something follows"),
            std::string::npos);
  std::string noNumber(plain.begin(), plain.end());
  for (std::size_t i = 0; i < 4; ++i) noNumber[noNumber.size() - 2 - i] = '\xff';
  EXPECT_NE(messageOf(folder.write("nan.roomgraph", noNumber)).find("is not a number"),
            std::string::npos);
}

}  // namespace
}  // namespace roomgraph
