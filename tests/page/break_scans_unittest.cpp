#include "break_scans.h"

#include <gtest/gtest.h>

#include "sample_comparison.h"

namespace roomgraph {
namespace {

TEST(BreakScans, areThoseOnEitherSideInTheFrameOfTheSite) {
  const auto sample = test::sampleComparison();
  const BreakScans scans = breakScans(sample.comparison, sample.comparison.breaks[0], sample.runs);
  ASSERT_FALSE(scans.before.empty() || scans.behind.empty());
  for (const auto* places : {&scans.before, &scans.behind}) {
    EXPECT_LE(places->size(), 250u);
    for (const Point p : *places) EXPECT_NEAR(std::abs(p.y - 6), 0.8, 1e-9) << "a wall of the hall";
  }
  // Key frame 12 stands at x = 9.5; a scan reaches 1 m to either side.
  for (const Point p : scans.before) EXPECT_LT(p.x, 9.5 - 0.75 + 1.01);
  for (const Point p : scans.behind) EXPECT_GT(p.x, 9.5 - 1.01);
}

TEST(BreakScans, aRunWithoutScansOrMapHasNone) {
  const auto sample = test::sampleComparison();
  EXPECT_TRUE(
      breakScans(sample.comparison, sample.comparison.breaks[1], sample.runs).behind.empty())
      << "no key frame";
  EXPECT_TRUE(breakScans(sample.comparison, sample.comparison.breaks[0], {}).before.empty());
}

}  // namespace
}  // namespace roomgraph
