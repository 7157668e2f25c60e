#include "roomgraph/archive/keep_map.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/map_sha256.h"
#include "sample_nights.h"

namespace roomgraph {
namespace {

std::string write(const std::string& file, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(file).parent_path());
  std::ofstream(file) << text;
  return file;
}

TEST(KeepMap, aCopyOutlivesItsMap) {
  const test::Folder folder;
  const std::string map = write(folder.file("latest.pgm"), "P2 2 1 255 0 254");
  const std::string sha256 = mapSha256(map);
  const std::string kept = keepMap(map, sha256, folder.file("kept"));
  EXPECT_EQ(std::filesystem::path(kept).filename(), "latest.pgm");
  EXPECT_EQ(keepMap(map, sha256, folder.file("kept")), kept);
  write(map, "P2 2 1 255 254 254");
  EXPECT_EQ(mapSha256(kept), sha256);
  EXPECT_NE(keepMap(map, mapSha256(map), folder.file("kept")), kept);
}

TEST(KeepMap, thePictureOfARosMapIsKeptWithIt) {
  const test::Folder folder;
  write(folder.file("map.pgm"), "P2 2 1 255 0 254");
  const std::string yaml =
      write(folder.file("map.yaml"), "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  const std::string kept = keepMap(yaml, mapSha256(yaml), folder.file("kept"));
  std::filesystem::remove(folder.file("map.pgm"));
  EXPECT_NO_THROW(mapSha256(kept));
}

TEST(KeepMap, whatCannotBeKeptIsRefused) {
  const test::Folder folder;
  write(folder.file("map.pgm"), "P2 2 1 255 0 254");
  const std::string yaml = write(folder.file("deep/map.yaml"),
                                 "image: ../map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  EXPECT_THROW(keepMap(yaml, mapSha256(yaml), folder.file("kept")), DataError);
  const std::string map = folder.file("map.pgm");
  EXPECT_THROW(keepMap(map, std::string(64, '0'), folder.file("kept")), DataError);
}

}  // namespace
}  // namespace roomgraph
