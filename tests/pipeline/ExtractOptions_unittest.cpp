#include "roomgraph/pipeline/ExtractOptions.h"

#include <gtest/gtest.h>

#include <set>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(Preset, paperHasThePapersNumbers) {
  const ExtractOptions options = preset("paper");
  EXPECT_EQ(options.binarize.blackThreshold, 100);
  EXPECT_EQ(options.thinObstacles.neighbours, "8");
  EXPECT_EQ(options.shortDeadEnds.minLengthPx, 20);
  EXPECT_GT(options.findRooms.alphaPx2, 0);
  EXPECT_TRUE(options.roomGraph.straightEdges);
}

TEST(Preset, throwsForAnUnknownName) { EXPECT_THROW(preset("fast"), UsageError); }

TEST(ExtractOptions, everyDefaultLiesInItsRange) {
  for (const char* name : {"default", "paper"}) {
    ExtractOptions options = preset(name);
    FieldTable table = describe(options);
    for (const Field& field : table.fields())
      EXPECT_NO_THROW(table.set(field.section, field.name, valueText(field)))
          << name << " [" << field.section << "] " << field.name;
  }
}

TEST(ExtractOptions, everyFieldHasAPlaceASentenceAndItsOwnName) {
  ExtractOptions options;
  std::set<std::string> seen;
  const FieldTable table = describe(options);
  for (const Field& field : table.fields()) {
    EXPECT_TRUE(seen.insert(field.section + "/" + field.name).second) << field.name;
    EXPECT_EQ(field.sentence.back(), '.') << field.name;
  }
  EXPECT_GT(seen.size(), 20u);
}

TEST(ExtractOptions, survivesTheIniFile) {
  ExtractOptions paper = preset("paper"), read;
  FieldTable from = describe(paper), to = describe(read);
  fromIni(toIni(from), "x.ini", to);
  EXPECT_EQ(toIni(to), toIni(from));
  ExtractOptions plain;
  EXPECT_NE(toIni(describe(plain)), toIni(from));
}

}  // namespace
}  // namespace roomgraph
