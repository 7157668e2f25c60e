#include "roomgraph/mrpt_plugin/CMapComparison.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>

#include "mrpt_reads.h"
#include "roomgraph/mrpt_plugin/map_comparison_file.h"
#include "roomgraph/mrpt_plugin/register_classes.h"
#include "sample_map_comparison.h"

namespace roomgraph {
namespace {

TEST(CMapComparison, comesBackFromAStreamThatKnowsOnlyItsName) {
  registerMrptClasses();
  const CMapComparison sample = test::sampleMapComparison();
  const auto back = test::fromItsName(sample);
  ASSERT_TRUE(back);
  EXPECT_EQ(mapComparisonBytes(*back), mapComparisonBytes(sample));
}

TEST(CMapComparison, aStreamThatEndsTooEarlyIsAnError) {
  registerMrptClasses();
  mrpt::io::CMemoryStream whole;
  mrpt::serialization::archiveFrom(whole) << test::sampleMapComparison();
  const auto size = static_cast<std::size_t>(whole.getTotalBytesCount());
  for (const std::size_t end : {size / 2, size - 2, std::size_t{44}}) {
    mrpt::io::CMemoryStream cut(whole.getRawBufferData(), end);
    auto archive = mrpt::serialization::archiveFrom(cut);
    CMapComparison back;
    EXPECT_ANY_THROW(archive >> back) << end << " of " << size << " bytes";
  }
}

TEST(CMapComparison, itsTextTellsVerdictRankingAndBreaks) {
  const std::string text = test::sampleMapComparison().asString();
  for (const char* part : {"good is the best map", "torn", "from key frame 12 on",
                           "at (1.00, 2.00) m, by 5.7 deg and 0.50 m"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in\n" << text;
}

TEST(CMapComparison, drawsItsLayersBesideWhatIsThere) {
  auto container = viz::CSetOfObjects::Create();
  container->insert(viz::CSetOfObjects::Create());
  test::sampleMapComparison().getVisualizationInto(*container);
  EXPECT_EQ(container->size(), 2U);
  for (const char* layer :
       {"comparison", "run good", "run torn", "rooms", "room names", "breaks", "legend"})
    EXPECT_TRUE(container->getByName(layer)) << layer;
}

}  // namespace
}  // namespace roomgraph
