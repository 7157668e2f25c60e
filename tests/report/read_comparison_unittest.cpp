#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "TestFolder.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/report/comparison_json.h"
#include "sample_comparison.h"

namespace roomgraph {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

/** Two runs of the sample, with a gate, so that all keys are there. */
const Json& document() {
  static const Json the = [] {
    Comparison comparison = test::sampleComparison().comparison;
    comparison.gate = GateVerdict{{"west: has no score"}, {"west"}, {"a score of 50 at least"}};
    comparison.core = {"morning"};
    comparison.reference = "morning";
    comparison.runs[0].welded = {8, 201};
    comparison.runs[1].score->givenUp = 0.25;
    return Json::parse(comparisonJson(comparison));
  }();
  return the;
}

/** The complaint about a document; empty for none. */
std::string complaintOf(const Json& json) {
  return test::refusalOf([&] { parseComparisonJson(json.dump(), "c.json"); });
}

/** Every key and every first entry of a list, as pointers. By value: \a all moves as it grows. */
void collect(const Json& json, Pointer at, std::vector<Pointer>& all) {
  if (json.is_object())
    for (const auto& item : json.items()) {
      all.push_back(at / item.key());
      collect(item.value(), all.back(), all);
    }
  if (json.is_array() && !json.empty()) {
    all.push_back(at / 0);
    collect(json[0], all.back(), all);
  }
}

std::vector<Pointer> places() {
  std::vector<Pointer> all;
  collect(document(), Pointer(""), all);
  return all;
}

TEST(ReadComparison, whatIsWeldedAreTwoKeyFrames) {
  Json json = document();
  json["runs"][0]["welded"] = {8};
  EXPECT_EQ(complaintOf(json),
            "c.json: runs[0].welded is not two key frames; write it anew with 'roomgraph compare'");
}

/** One line that names the file. */
void expectOneLine(const std::string& complaint, const std::string& about) {
  EXPECT_EQ(complaint.rfind("c.json: ", 0), 0u) << about << ": " << complaint;
  EXPECT_EQ(complaint.find('\n'), std::string::npos) << about << ": " << complaint;
}

TEST(ReadComparison, whatContradictsAReferenceIsKept) {
  const Comparison read = parseComparisonJson(document().dump(), "c.json");
  EXPECT_DOUBLE_EQ(read.runs[1].score->givenUp, 0.25);
  EXPECT_FALSE(read.runs[1].score->fitsReference());
}

TEST(ReadComparison, aWholeDocumentIsRead) { EXPECT_EQ(complaintOf(document()), ""); }

TEST(ReadComparison, aKeyThatIsMissingIsNamed) {
  // What tells the file from others, what is not always written, and what nobody reads.
  const std::set<std::string> mayLack{"format", "core", "program", "inputs"};
  std::size_t named = 0;
  for (const Pointer& at : places()) {
    const bool isEntry = document()[at.parent_pointer()].is_array();
    if (isEntry || mayLack.count(at.back())) continue;
    Json json = document();
    json[at.parent_pointer()].erase(at.back());
    const std::string complaint = complaintOf(json);
    if (complaint.empty()) continue;  // a member of a map, such as a measure or an option
    ++named;
    expectOneLine(complaint, at.to_string());
    EXPECT_NE(complaint.find("'" + at.back() + "'"), std::string::npos)
        << at.to_string() << ": " << complaint;
  }
  EXPECT_GT(named, 70u);
}

TEST(ReadComparison, nothingOfAnotherKindIsTakenNorCrashes) {
  std::size_t refused = 0, all = 0;
  for (const Pointer& at : places())
    for (const Json& other : {Json("text"), Json(-7), Json(1e300), Json(true), Json(nullptr),
                              Json::array(), Json::object(), Json::array({1, 2, 3, 4})}) {
      Json json = document();
      if (json[at].type() == other.type()) continue;
      json[at] = other;
      const std::string complaint = complaintOf(json);
      ++all, refused += !complaint.empty();
      if (!complaint.empty()) expectOneLine(complaint, at.to_string());
    }
  EXPECT_GT(all, 700u);
  EXPECT_GT(double(refused), 0.6 * double(all)) << "the rest are texts, or may be nothing";
}

TEST(ReadComparison, aMeasureThatIsNotAnObjectIsRefused) {
  Json json = document();
  json["runs"][0]["measures"] = Json::array({1});
  EXPECT_NE(complaintOf(json).find("runs[0].measures"), std::string::npos) << complaintOf(json);
  json = document();
  json["runs"][0]["measures"]["coverage"]["support"] = "many";
  EXPECT_NE(complaintOf(json).find("runs[0].measures.coverage.support"), std::string::npos);
}

TEST(ReadComparison, placesLieWhereSomethingCanBeDrawn) {
  for (const char* at : {"/runs/0/pose/0", "/runs/0/path/0/x", "/rooms/0/x", "/rooms/0/polygon/0/1",
                         "/breaks/0/x"}) {
    Json json = document();
    ASSERT_TRUE(json.contains(Pointer(at))) << at;
    json[Pointer(at)] = 1e308;
    EXPECT_NE(complaintOf(json).find("is too far away to be a place"), std::string::npos) << at;
  }
}

TEST(ReadComparison, countsAreWholeAndNotTooMany) {
  for (const Json& bad : {Json(-1), Json(0.5), Json(1e12), Json("3")}) {
    Json json = document();
    json["runs"][0]["rank"] = bad;
    EXPECT_NE(complaintOf(json).find("runs[0].rank"), std::string::npos) << bad;
  }
}

TEST(ReadComparison, anOptionThatThisVersionDoesNotKnowIsKept) {
  Json json = document();
  json["options"]["teleport"]["range"] = 12;
  const Comparison read = parseComparisonJson(json.dump(), "c.json");
  bool isThere = false;
  for (const UsedOption& option : read.options)
    isThere = isThere || (option.section == "teleport" && option.value == "12");
  EXPECT_TRUE(isThere);
}

TEST(ReadComparison, isReadFromItsFile) {
  const TestFolder folder;
  const std::string file = folder / "comparison.json";
  writeFileAtomically(file, document().dump());
  EXPECT_EQ(readComparison(file).verdict, test::sampleComparison().comparison.verdict);
  EXPECT_THROW(readComparison(folder / "none.json"), DataError);
}

}  // namespace
}  // namespace roomgraph
