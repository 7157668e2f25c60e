#include <gtest/gtest.h>

#include "page_summary.h"
#include "roomgraph/compare/compare_maps.h"

namespace roomgraph {
namespace {

TEST(CommandLine, namesTheMapsAndWhatIsNotAsUsual) {
  Comparison comparison;
  comparison.runs.resize(3);
  comparison.runs[0].name = "b", comparison.runs[0].file = "nights/b.simplemap";
  comparison.runs[1].name = "a", comparison.runs[1].file = "it's a.simplemap";
  comparison.runs[2].name = "plan", comparison.runs[2].file = "plan.png";
  comparison.leftOut = {{"c", "c.yaml", "damaged", false}};
  comparison.reference = "plan";
  comparison.options = usedOptions({});
  for (UsedOption& option : comparison.options) {
    if (option.name == "max_size") option.value = "2";
    if (option.name == "estimate_scale") option.value = "true";
    if (option.name == "reference") option.value = "maps/plan.png";
  }
  EXPECT_EQ(commandLine(comparison),
            "roomgraph compare b.simplemap c.yaml 'it'\\''s a.simplemap' --set "
            "clear_clutter.max_size=2 --estimate-scale --reference plan.png");
}

TEST(CommandLine, theUsualOptionsAreNotNamed) {
  Comparison comparison;
  comparison.options = usedOptions({});
  EXPECT_EQ(commandLine(comparison), "roomgraph compare");
}

}  // namespace
}  // namespace roomgraph
