#include <gtest/gtest.h>

#include <filesystem>

#include "clouds.h"

namespace roomgraph {
namespace {

class ExternalFile : public test::Clouds {};

TEST_F(ExternalFile, cloudsInFilesBesideTheMapAreRead) {
  writeBeside("a.bin", test::gzipped(simple_));
  expectRoom(load(outside(3, "a.bin")));
  writeBeside("a.bin", test::zstd(simple_, false));
  expectRoom(load(outside(3, "a.bin")));
  dir_.write("b.bin", simple_);
  expectRoom(load(outside(3, "b.bin")));
}

TEST_F(ExternalFile, cloudsOfTheMapThatThisOneWasMadeFromAreRead) {
  std::filesystem::create_directories(dir_.path("final_map_Images"));
  dir_.write("final_map_Images/lidar_1700000000.5.bin", test::gzipped(simple_));
  expectRoom(load(outside(3, "lidar_1700000000.5.bin")));
  EXPECT_NE(errorOf(outside(3, "lidar_1700000001.5.bin")).find("run_Images"), std::string::npos);
}

TEST_F(ExternalFile, filesOfKittiAndTextsAreRead) {
  std::string kitti, text;
  for (const auto& p : points_) {
    kitti += test::raw(p.x) + test::raw(p.y) + test::raw(p.z) + test::raw(0.5f);
    text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  }
  writeBeside("a.bin", kitti);
  expectRoom(load(outside(1, "a.bin")));
  writeBeside("a.txt", text);
  expectRoom(load(outside(2, "a.txt")));
}

TEST_F(ExternalFile, missingFilesAreNamedInOneLine) {
  const std::string text = errorOf(outside(3, "lidar_17.bin"));
  EXPECT_NE(text.find("1 of its 1 point clouds"), std::string::npos) << text;
  EXPECT_NE(text.find("lidar_17.bin"), std::string::npos) << text;
  EXPECT_NE(text.find("run_Images"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST_F(ExternalFile, damagedFilesBesideTheMapAreRefused) {
  writeBeside("a.bin", simple_.substr(0, 500));
  EXPECT_NE(errorOf(outside(3, "a.bin")).find("a.bin"), std::string::npos);
  writeBeside("a.bin", test::streamed(test::smallGrid()));
  EXPECT_NE(errorOf(outside(3, "a.bin")).find("COccupancyGridMap2D"), std::string::npos);
}

TEST(SlicedRun, namesTheFilesThatAreMissing) {
  const std::string file = test::sharedFile("mrpt_new/v1_external_cloud.simplemap");
  if (file.empty()) GTEST_SKIP() << "the run is not there";
  try {
    loadGrid(file, {});
    FAIL();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("lidar_0.bin"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace roomgraph
