#include "roomgraph/map_files/map_formats.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace roomgraph {
namespace {

std::string textOf(const std::string& file) {
  std::ifstream in(ROOMGRAPH_SOURCE_DIR + file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(MapFormats, haveEachTheirKindAndExtensions) {
  std::set<std::string> kinds, extensions;
  std::size_t count = 0;
  for (const MapFormat& format : mapFormats()) {
    kinds.insert(format.kind);
    for (const std::string extension : format.extensions) {
      extensions.insert(extension);
      ++count;
      EXPECT_EQ(extension[0], '.');
    }
  }
  EXPECT_EQ(kinds.size(), mapFormats().size());
  EXPECT_EQ(extensions.size(), count);
}

TEST(MapFormats, areListedWherePeopleLook) {
  for (const std::string file : {"/docs/formats.md", "/apps/roomgraph/README.md"}) {
    const std::string text = textOf(file);
    ASSERT_NE(text, "") << file;
    for (const MapFormat& format : mapFormats())
      for (const std::string extension : format.extensions)
        EXPECT_NE(text.find("`" + extension + "`"), std::string::npos) << extension << file;
  }
}

TEST(MapFormats, areTheKindsOfTheSchema) {
  std::string kinds;
  for (const MapFormat& format : mapFormats())
    kinds += (kinds.empty() ? "\"" : ", \"") + std::string(format.kind) + "\"";
  // A program may also give the cells as an array.
  const std::string listed = "\"enum\": [" + kinds + ", \"array\"]";
  EXPECT_NE(textOf("/share/roomgraph/schema/graph-1.schema.json").find(listed), std::string::npos)
      << kinds;
}

}  // namespace
}  // namespace roomgraph
