#include "roomgraph/report/comparison_csv.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "roomgraph/measures/measure_kinds.h"
#include "sample_comparison.h"

namespace roomgraph {
namespace {

TEST(ComparisonRunsCsv, hasAColumnForEachKindOfMeasure) {
  const std::string csv = comparisonRunsCsv(test::sampleComparison().comparison),
                    header = csv.substr(0, csv.find('\n'));
  std::string names;
  for (const MeasureKind& kind : runMeasureKinds()) names += std::string(",") + kind.name;
  names += ",break_key_frames,break_places,break_turns_deg,break_shifts_m";
  EXPECT_EQ(header.substr(header.find(",phi,") + 4), names);
}

TEST(ComparisonRunsCsv, aMeasureStandsInItsColumnWhereverItIsInTheRun) {
  Comparison comparison = test::sampleComparison().comparison;
  const std::string before = comparisonRunsCsv(comparison);
  for (ComparedRun& run : comparison.runs) std::reverse(run.measures.begin(), run.measures.end());
  EXPECT_EQ(comparisonRunsCsv(comparison), before);
}

TEST(ComparisonRunsCsv, endsWithTheBreaksOfTheRun) {
  Comparison comparison = test::sampleComparison().comparison;
  for (MapBreak& tear : comparison.breaks) tear.run = "evening";
  const std::string csv = comparisonRunsCsv(comparison);
  EXPECT_NE(csv.find(",12;-,8.0000 6.0000;12.0000 9.0000,4.0107;-2.8648,0.5800;0.3000\n"),
            std::string::npos)
      << csv;
  EXPECT_NE(csv.find(",,,,\n"), std::string::npos) << "a run without breaks";
}

}  // namespace
}  // namespace roomgraph
