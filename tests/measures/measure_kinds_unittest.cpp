#include "roomgraph/measures/measure_kinds.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "measure_table.h"
#include "schemas.h"

namespace roomgraph {
namespace {

std::vector<MeasureKind> all() {
  std::vector<MeasureKind> kinds;
  for (const MeasureRow& row : measureTable()) kinds.push_back(row.kind);
  return kinds;
}

TEST(MeasureKinds, allIsSaidOfEach) {
  std::set<std::string> names, labels;
  for (const MeasureKind& kind : all()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_TRUE(labels.insert(kind.label).second) << kind.label;
    EXPECT_EQ(findMeasureKind(kind.name)->label, std::string(kind.label));
  }
}

std::string textOf(const char* file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/** Where a measure should stand outside of the table, and does not. */
std::vector<std::string> placesWithout(const MeasureKind& kind) {
  static const std::string document = textOf(ROOMGRAPH_SCORING);
  static const std::string schema = test::schemaText("comparison");
  std::vector<std::string> missing;
  const std::string name = kind.name;
  const bool isHop = name.rfind("consistency_", 0) == 0 && name != "consistency_1";
  if (document.find("`" + (isHop ? name.substr(11) : name) + "`") == std::string::npos)
    missing.push_back("docs/scoring.md lacks " + name);
  const std::string units = schema.substr(schema.find("\"unit\": {"));
  if (units.find("\"" + std::string(kind.unit) + "\"") > units.find('\n'))
    missing.push_back("comparison-1.schema.json lacks " + std::string(kind.unit));
  return missing;
}

TEST(MeasureKinds, eachStandsInTheDocumentAndItsUnitInTheSchema) {
  for (const MeasureKind& kind : all())
    EXPECT_EQ(placesWithout(kind), std::vector<std::string>{}) << kind.name;
}

TEST(MeasureKinds, aForgottenPlaceIsFound) {
  EXPECT_EQ(placesWithout({"smell", "Smell", "olf", 0}),
            (std::vector<std::string>{"docs/scoring.md lacks smell",
                                      "comparison-1.schema.json lacks olf"}));
}

TEST(MeasureKinds, thoseOfRunsAreSomeOfAll) {
  EXPECT_LT(runMeasureKinds().size(), all().size());
  for (const MeasureKind& ofRun : runMeasureKinds())
    EXPECT_EQ(findMeasureKind(ofRun.name)->label, std::string(ofRun.label));
  EXPECT_EQ(findMeasureKind("smell"), nullptr);
}

}  // namespace
}  // namespace roomgraph
