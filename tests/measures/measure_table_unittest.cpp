#include "measure_table.h"

#include <gtest/gtest.h>

#include "roomgraph/measures/measure_kinds.h"

namespace roomgraph {
namespace {

TEST(MeasureTable, eachMeasureIsComputedOfARunOrAPair) {
  for (const MeasureRow& row : measureTable())
    EXPECT_TRUE(row.ofRun || row.ofPair) << row.kind.name;
}

TEST(MeasureTable, whatIsSaidOfAMeasureIsSaidOfItsRow) {
  for (const MeasureRow& row : measureTable())
    EXPECT_EQ(findMeasureKind(row.kind.name), &row.kind) << "or the name stands twice";
}

}  // namespace
}  // namespace roomgraph
