#include "roomgraph/mrpt_plugin/CRoomGraph.h"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>

#include "mrpt_reads.h"
#include "refusal.h"
#include "roomgraph/mrpt_plugin/graph_text.h"
#include "roomgraph/mrpt_plugin/register_classes.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "sample_graph.h"

namespace roomgraph {
namespace {

TEST(CRoomGraph, isFoundByNameOnceRegistered) {
  registerMrptClasses();
  registerMrptClasses();
  const auto* found = mrpt::rtti::findRegisteredClass("roomgraph::CRoomGraph");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found, CLASS_ID(CRoomGraph));
}

TEST(CRoomGraph, comesBackFromAStreamThatKnowsOnlyItsName) {
  registerMrptClasses();
  const CRoomGraph sample = sampleGraph();
  const auto back = test::fromItsName(sample);
  ASSERT_TRUE(back);
  EXPECT_EQ(roomGraphBytes(*back), roomGraphBytes(sample));
}

TEST(CRoomGraph, aStreamThatEndsTooEarlyIsAnError) {
  registerMrptClasses();
  mrpt::io::CMemoryStream whole;
  mrpt::serialization::archiveFrom(whole) << sampleGraph();
  const auto size = static_cast<std::size_t>(whole.getTotalBytesCount());
  for (const std::size_t end : {size / 2, size - 2, std::size_t{40}}) {
    mrpt::io::CMemoryStream cut(whole.getRawBufferData(), end);
    auto archive = mrpt::serialization::archiveFrom(cut);
    CRoomGraph back;
    const std::string text = test::refusalOf<std::exception>([&] { archive >> back; });
    // MRPT's stream adds its own lines.
    EXPECT_NE(text.find("room graph: it is cut short or damaged"), std::string::npos)
        << end << " of " << size << " bytes: " << text;
  }
}

TEST(CRoomGraph, describesItselfByGraphText) {
  const CRoomGraph sample = sampleGraph();
  EXPECT_EQ(sample.asString(), graphText(sample.file));
}

TEST(CRoomGraph, drawsItselfBesideWhatIsThere) {
  auto container = viz::CSetOfObjects::Create();
  container->insert(viz::CSetOfObjects::Create());
  sampleGraph().getVisualizationInto(*container);
  EXPECT_EQ(container->size(), 2U);
  EXPECT_TRUE(container->getByName("room graph"));
}

}  // namespace
}  // namespace roomgraph
