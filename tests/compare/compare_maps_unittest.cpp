#include "roomgraph/compare/compare_maps.h"

#include <gtest/gtest.h>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

TEST(CompareMaps, whatWasUsedCanBeSetAgain) {
  CompareMapsOptions options;
  FieldTable table = describe(options);
  table.set("run_score", "scale", "0.25");
  table.set("run_score", "min_share", "0.4");
  table.set("site_breaks", "min_shift", "0.7");
  table.set("site_breaks", "min_rotation", "0.1");
  table.set("compare", "aligned", "true");
  table.set("join_doors", "max_depth", "0.3");
  Comparison comparison;
  comparison.options = usedOptions(options);

  CompareMapsOptions again;
  FieldTable known = describe(again);
  setUsed(comparison, known);
  EXPECT_EQ(again.compare.scoreScale, 0.25);
  EXPECT_EQ(again.compare.leastShare, 0.4);
  EXPECT_EQ(again.compare.breakShift, 0.7);
  EXPECT_EQ(again.compare.breakRotation, 0.1);
  EXPECT_TRUE(again.compare.areAligned);
  EXPECT_EQ(toIni(describe(again)), toIni(describe(options)));
}

TEST(CompareMaps, optionsOfOtherVersionsAreLeftOut) {
  Comparison comparison;
  comparison.options = {{"run_score", "scale", "2", "m", ""}, {"run_score", "smell", "2", "", ""}};
  CompareMapsOptions options;
  FieldTable table = describe(options);
  setUsed(comparison, table);
  EXPECT_EQ(options.compare.scoreScale, 2);
}

TEST(CompareMaps, aValueOutOfRangeIsRefused) {
  CompareMapsOptions options;
  FieldTable table = describe(options);
  EXPECT_THROW(table.set("run_score", "scale", "0"), UsageError);
  EXPECT_THROW(table.set("run_score", "min_share", "1.1"), UsageError);
}

}  // namespace
}  // namespace roomgraph
