#include "roomgraph/graph_files/read_graph_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "TestFolder.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/write_file.h"
#include "roomgraph/graph_files/graph_json.h"
#include "sample_stages.h"

namespace roomgraph {
namespace {

using OrderedJson = nlohmann::ordered_json;

/** The message for a text that must be refused; "" where it is not. */
std::string refusal(const std::string& text) {
  return test::refusalOf([&] { parseGraphJson(text, "x.json"); });
}

void expectOneLine(const std::string& message) {
  EXPECT_EQ(message.rfind("x.json: ", 0), 0u) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_LT(message.size(), 200u) << message;
}

TEST(ReadGraphJson, writtenAgainGivesTheSameBytes) {
  for (const Stages& stages : {sampleStages(), extractedStages()}) {
    const std::string text = graphJson(stages);
    EXPECT_EQ(graphJson(parseGraphJson(text, "x.json")), text);
  }
}

TEST(ReadGraphJson, givesDoorsToUnseenSpaceBackAndHowMuchOfAnAreaWasSeen) {
  Stages stages = sampleStages();
  stages.areas.passages[1].b = AreaId::none();
  stages.areas.areas[0].seen = 0.625;
  const GraphFile file = parseGraphJson(graphJson(stages), "x.json");
  EXPECT_FALSE(file.areas.passages[1].b);
  EXPECT_EQ(file.areas.areas[0].seen, 0.625);
  EXPECT_EQ(file.areas.areas[1].seen, std::nullopt);
}

TEST(ReadGraphJson, givesTheNamesOfAreasBack) {
  GraphFile file = graphFile(sampleStages());
  for (std::size_t a = 0; a < file.areas.areas.size(); ++a)
    file.areaNames.push_back("Room \"" + std::to_string(a) + "\"");
  ASSERT_FALSE(file.areaNames.empty());
  const std::string text = graphJson(file);
  EXPECT_EQ(parseGraphJson(text, "x.json").areaNames, file.areaNames);
  const std::string first = R"(,"name":"Room \"0\"")";
  expectOneLine(refusal(std::string(text).erase(text.find(first), first.size())));
}

TEST(ReadGraphJson, givesNotesAndNoLabelsBack) {
  const GraphFile file = parseGraphJson(graphJson(sampleStages()), "x.json");
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_FALSE(file.notes[1].where);
  EXPECT_TRUE(file.areas.labels.empty());
}

TEST(ReadGraphJson, areasAndPassagesAreAlwaysThere) {
  for (const char* key : {"areas", "passages"}) {
    OrderedJson json = OrderedJson::parse(graphJson(sampleStages()));
    json.erase(key);
    expectOneLine(refusal(json.dump()));
  }
  OrderedJson json = OrderedJson::parse(graphJson(sampleStages()));
  json["passages"][1].erase("evidence");
  expectOneLine(refusal(json.dump()));
}

TEST(ReadGraphJson, givesTheOptionsBackAsAnIniFile) {
  Stages stages = sampleStages();
  stages.options.findRooms.minWidth = 2.25;
  stages.options.keepComponents.onlyLargest = true;
  stages.options.thinObstacles.neighbours = "4";
  const GraphFile file = parseGraphJson(graphJson(stages), "x.json");
  ExtractOptions options;
  FieldTable table = describe(options);
  fromIni(optionsIni(file), "x.json", table);
  EXPECT_EQ(options.findRooms.minWidth, 2.25);
  EXPECT_TRUE(options.keepComponents.onlyLargest);
  EXPECT_EQ(options.thinObstacles.neighbours, "4");
  FieldTable written = describe(stages.options);
  EXPECT_EQ(toIni(table), toIni(written));
}

TEST(ReadGraphJson, skipsFieldsItDoesNotKnow) {
  const std::string text = graphJson(sampleStages());
  OrderedJson json = OrderedJson::parse(text);
  json["furniture"] = OrderedJson::array({1, 2});
  json["vertices"][0]["name"] = "kitchen";
  EXPECT_EQ(graphJson(parseGraphJson(json.dump(), "x.json")), text);
}

TEST(ReadGraphJson, everyTruncationIsRefusedInOneLine) {
  const std::string text = graphJson(sampleStages());
  // The last two characters are the closing brace and the end of its line.
  for (std::size_t size = 0; size + 2 <= text.size(); size += 7) {
    const std::string message = refusal(text.substr(0, size));
    expectOneLine(message);
  }
}

/** Places of the file, and what must not stand there. */
const std::pair<const char*, OrderedJson> kWrong[] = {
    {"/format", "geojson"},
    {"/version", 2},
    {"/program", 1},
    {"/input/size", OrderedJson::array({1, 2, 3})},
    {"/input/size", OrderedJson::array({-1, 2})},
    {"/input/origin", "here"},
    {"/options", OrderedJson::array()},
    {"/options/find_rooms", 1},
    {"/options/find_rooms/min_width", OrderedJson::array()},
    {"/vertices", 3},
    {"/vertices/1/id", 0},
    {"/vertices/0/kind", "door"},
    {"/vertices/0/room", 2},
    {"/vertices/0/x", "1"},
    {"/edges/0/source", 7},
    {"/edges/0/target", -1},
    {"/edges/0/target", 1.5},
    {"/edges/0/path", OrderedJson::array()},
    {"/edges/0/path/0", OrderedJson::array({1, 2, 3})},
    {"/rooms/0/vertex", 99},
    {"/rooms/0/border_vertices/0", nullptr},
    {"/rooms/0/polygon", 4},
    {"/notes/0/code", nullptr},
    {"/areas", nullptr},
    {"/areas/1/id", 0},
    {"/areas/0/room", 2},
    {"/areas/0/kind", "corridor"},
    {"/areas/2/kind", "room"},
    {"/areas/0/passages/0", 2},
    {"/areas/0/polygon/0", OrderedJson::array({1})},
    {"/areas/0/inscribed_radius", "1"},
    {"/passages", 1},
    {"/passages/1/id", 2},
    {"/passages/0/areas/1", 3},
    {"/passages/0/areas", OrderedJson::array({0, 1, 2})},
    {"/passages/0/ends", OrderedJson::array({OrderedJson::array({1, 2})})},
    {"/passages/0/width", nullptr},
    {"/passages/0/confidence", 1.1},
    {"/passages/0/confidence", nullptr},
    {"/passages/0/evidence", "door"},
};

TEST(ReadGraphJson, everyWrongValueIsRefusedInOneLine) {
  const OrderedJson good = OrderedJson::parse(graphJson(sampleStages()));
  for (const auto& [place, value] : kWrong) {
    OrderedJson broken = good;
    broken[OrderedJson::json_pointer(place)] = value;
    SCOPED_TRACE(place);
    expectOneLine(refusal(broken.dump()));
  }
}

TEST(ReadGraphJson, otherJsonIsRefused) {
  for (const char* text : {"", "null", "[]", "{}", "42", "{\"format\": 1}", "{\"format\"}"})
    expectOneLine(refusal(text));
  EXPECT_NE(refusal("{}").find("roomgraph/graph"), std::string::npos);
}

TEST(ReadGraphJson, readsFilesAndNamesTheOnesItCannotRead) {
  const TestFolder folder;
  writeFileAtomically(folder / "x.json", graphJson(sampleStages()));
  EXPECT_EQ(readGraphJson(folder / "x.json").graph.rooms.size(), 2u);
  EXPECT_THROW(readGraphJson(folder / "y.json"), DataError);
  EXPECT_THROW(readGraphJson(folder.path()), DataError);
}

}  // namespace
}  // namespace roomgraph
