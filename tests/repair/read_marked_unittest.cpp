#include <gtest/gtest.h>

#include "TestFolder.h"
#include "carried_by.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {
namespace {

TEST(ReadMarked, theContentTellsTheFormat) {
  const TestFolder folder;
  const auto kindOf = [&](const std::string& text) {
    return std::string(readMarked(folder.write("things", text)).kind);
  };
  folder.write("mask.pgm", "P5\n1 1\n255\n~");
  EXPECT_EQ(kindOf("x,y\n1,2\n"), "place");
  EXPECT_EQ(kindOf("{\"type\":\"Point\",\"coordinates\":[1,2]}"), "feature");
  EXPECT_EQ(kindOf("{\"format\":\"roomgraph/site\",\"rooms\":[]}"), "room");
  EXPECT_EQ(kindOf("<osm><node id='1' lat='0' lon='0'><tag k='name' v='root'/></node></osm>"),
            "way");
  EXPECT_EQ(kindOf("image: mask.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"), "region");
}

TEST(ReadMarked, othersAreRefusedInOneLine) {
  const TestFolder folder;
  for (const std::string text :
       {"", "P5\n1 1\n255\n~", "{\"a\":1}", "<a/>", "image: a\n", "a,b\n"}) {
    const std::string line = test::refusalOf([&] { readMarked(folder.write("things", text)); });
    EXPECT_NE(line, "") << text;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
  EXPECT_THROW(readMarked(folder / "none"), DataError);
}

TEST(ReadMarked, filesHaveTheirNamesBeforeAndAStateAfterTheyAreCarried) {
  const TestFolder folder;
  for (const std::string text :
       {"name,x,y\ndock,1,2\n", "{\"type\":\"Point\",\"coordinates\":[1,2]}",
        "{\"type\":\"FeatureCollection\",\"features\":[]}",
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":null}]}",
        "<osm>\n<node id='1' lat='0' lon='0'><tag k='name' v='root'/></node>\n<node id='2' lat='0' "
        "lon='0'/>\n<node id='3' lat='0' lon='0'/>\n<way id='4'>\n<nd ref='2'/>\n<nd "
        "ref='3'/>\n</way>\n</osm>\n"}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(isCarried(text));
    const MarkedFile marked = readMarked(folder.write("things", text));
    const auto written = marked.write(test::carriedBy({1, 2, 0}, marked), {});
    ASSERT_EQ(written.size(), 1u);
    EXPECT_EQ(marked.files, std::vector<std::string>{written[0].name});
    EXPECT_TRUE(isCarried(written[0].bytes)) << written[0].bytes;
  }
}

}  // namespace
}  // namespace roomgraph
