#include "roomgraph/map_files/map_sha256.h"

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

TEST(MapSha256, isThatOfTheMap) {
  const TestFolder folder;
  const std::string picture = folder.write("map.pgm", "P2 2 1 255 0 254");
  const std::string yaml =
      folder.write("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  const std::string before = mapSha256(yaml);
  for (const std::string& file : {picture, yaml})
    EXPECT_EQ(mapSha256(file), loadGrid(file, {}).source.sha256);
  EXPECT_NE(before, mapSha256(picture));
  folder.write("map.pgm", "P2 2 1 255 254 254");
  EXPECT_NE(before, mapSha256(yaml));
}

TEST(MapSha256, whatCannotBeReadHasNone) {
  const TestFolder folder;
  EXPECT_THROW(mapSha256("none.pgm"), DataError);
  EXPECT_THROW(mapSha256(folder.write("a.yaml", "image: none.pgm\nresolution: 0.5\n")), DataError);
}

}  // namespace
}  // namespace roomgraph
