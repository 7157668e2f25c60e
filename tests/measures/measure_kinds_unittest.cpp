#include "roomgraph/measures/measure_kinds.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "roomgraph/measures/Measure.h"

namespace roomgraph {
namespace {

std::vector<MeasureKind> all() {
  std::vector<MeasureKind> kinds = runMeasureKinds();
  kinds.insert(kinds.end(), pairMeasureKinds().begin(), pairMeasureKinds().end());
  return kinds;
}

TEST(MeasureKinds, allIsSaidOfEach) {
  std::set<std::string> names, labels;
  for (const MeasureKind& kind : all()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_TRUE(labels.insert(kind.label).second) << kind.label;
    EXPECT_NE(std::string(kind.sentence), "") << kind.name;
    EXPECT_EQ(findMeasureKind(kind.name)->label, std::string(kind.label));
  }
}

TEST(MeasureKinds, eachStandsInTheDocumentAndItsUnitInTheSchema) {
  std::ostringstream document, schema;
  document << std::ifstream(ROOMGRAPH_SCORING).rdbuf();
  schema << std::ifstream(ROOMGRAPH_COMPARISON_SCHEMA).rdbuf();
  const std::string units = schema.str().substr(schema.str().find("\"unit\": {"));
  for (const MeasureKind& kind : all()) {
    const std::string name = kind.name;
    const bool isHop = name.rfind("consistency_", 0) == 0 && name != "consistency_1";
    const std::string inText = "`" + (isHop ? name.substr(11) : name) + "`";
    EXPECT_NE(document.str().find(inText), std::string::npos) << name;
    EXPECT_LT(units.find("\"" + std::string(kind.unit) + "\""), units.find('\n')) << name;
  }
}

TEST(MeasureKinds, aMeasureThatStandsInNoTableIsRefused) {
  EXPECT_EQ(measureNamed("bend").unit, "m");
  EXPECT_THROW(measureNamed("bent"), std::logic_error);
}

TEST(MeasureKinds, supportMakesAMeasureMeaningful) {
  const double least = findMeasureKind("followed")->leastSupport;
  EXPECT_TRUE(measureNamed("followed", 0.5, least).isMeaningful);
  EXPECT_FALSE(measureNamed("followed", 0.5, least - 1).isMeaningful);
  EXPECT_FALSE(measureNamed("followed", {}, least).isMeaningful);
}

}  // namespace
}  // namespace roomgraph
