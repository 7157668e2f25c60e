#include <gtest/gtest.h>
#include <mrpt/io/lazy_load_path.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <cstdlib>
#include <filesystem>

#include "TestFolder.h"
#include "clouds.h"
#include "refusal.h"

namespace roomgraph {
namespace {

class ExternalFile : public test::Clouds {};

TEST_F(ExternalFile, cloudsInFilesBesideTheMapAreRead) {
  writeBeside("a.bin", test::gzipped(simple_));
  expectRoom(load(outside(1, "a.bin")));
  writeBeside("a.bin", test::zstd(simple_, false));
  expectRoom(load(outside(1, "a.bin")));
  dir_.write("b.bin", simple_);
  expectRoom(load(outside(1, "b.bin")));
}

TEST_F(ExternalFile, whatMrptItselfWritesIsRead) {
  using mrpt::obs::CObservationPointCloud;
  std::filesystem::create_directories(dir_ / "run_Images");
  const std::string before = mrpt::io::getLazyLoadPathBase();
  mrpt::io::setLazyLoadPathBase(dir_ / "run_Images");
  using Format = CObservationPointCloud::ExternalStorageFormat;
  for (const Format format : {Format::MRPT_Serialization, Format::PlainTextFile}) {  // not KITTI's
    SCOPED_TRACE(int(format));
    CObservationPointCloud cloud;
    cloud.sensorPose = sensor_;
    cloud.pointcloud = mrpt::maps::CSimplePointsMap::Create();
    for (const auto& p : points_) cloud.pointcloud->insertPoint(p.x, p.y, p.z);
    const std::string name = "cloud" + std::to_string(int(format));
    cloud.setAsExternalStorage(name, format);
    cloud.unload();  // to the file
    ASSERT_TRUE(test::isFile(dir_ / ("run_Images/" + name)));
    expectRoom(load(test::oneObservation(test::streamed(cloud))));
  }
  mrpt::io::setLazyLoadPathBase(before);
}

TEST_F(ExternalFile, storageThatIsNotKnownIsRefused) {
  writeBeside("a.bin", simple_);
  EXPECT_NE(errorOf(outside(4, "a.bin")).find("a kind that is not known"), std::string::npos);
}

TEST_F(ExternalFile, aMapThatWasRenamedHasItsCloudsAndSaysSo) {
  std::filesystem::create_directories(dir_ / "final_map_Images");
  dir_.write("final_map_Images/lidar_1700000000.5.bin", test::gzipped(simple_));
  const std::string renamed = outside(1, "lidar_1700000000.5.bin");
  const GreyMap map = load(renamed);
  expectRoom(map);
  EXPECT_EQ(map.notes.at(1).code, "other_folder");
  EXPECT_TRUE(map.notes.at(1).isWarning) << "they may be those of another drive";
  EXPECT_NE(map.notes.at(1).text.find("final_map_Images"), std::string::npos);
  EXPECT_NE(errorOf(outside(1, "lidar_1700000001.5.bin")).find("run_Images"), std::string::npos);

  std::filesystem::create_directories(dir_ / "older_Images");
  EXPECT_NE(errorOf(renamed), "") << "nobody knows which of two";
  dir_.write("older.simplemap.gz", "its own map");
  EXPECT_EQ(errorOf(renamed), "") << "that one has a map";
  std::filesystem::create_directories(dir_ / "run_Images");
  EXPECT_NE(errorOf(renamed), "") << "it has a folder of its own";
}

TEST_F(ExternalFile, cloudsOfAnotherMapAreLeftAlone) {
  std::filesystem::create_directories(dir_ / "other_Images");
  dir_.write("other_Images/lidar_0.bin", simple_);
  dir_.write("other.simplemap", "a map of its own");
  EXPECT_NE(errorOf(outside(1, "lidar_0.bin")).find("lidar_0.bin"), std::string::npos);
}

TEST_F(ExternalFile, aMapOpensNoFilesOfOthers) {
  const TestFolder elsewhere;
  const std::string secret = elsewhere.write("secret.bin", simple_);
  EXPECT_NE(errorOf(outside(1, secret)), "");
  const auto way = std::filesystem::relative(secret, dir_ / "run_Images").string();
  for (const std::string& name : {way, "x/../" + way, std::string(".."), std::string("/")})
    EXPECT_NE(errorOf(outside(1, name)), "") << name;
  writeBeside("secret.bin", simple_);
  expectRoom(load(outside(1, secret)));  // of the name that MOLA wrote when the files lay there
}

TEST_F(ExternalFile, cloudsMayBeInFoldersBelow) {
  std::filesystem::create_directories(dir_ / "run_Images/front");
  dir_.write("run_Images/front/a.bin", simple_);
  expectRoom(load(outside(1, "front/a.bin")));
}

TEST_F(ExternalFile, filesOfKittiAndTextsAreRead) {
  std::string kitti, text;
  for (const auto& p : points_) {
    kitti += test::raw(p.x) + test::raw(p.y) + test::raw(p.z) + test::raw(0.5f);
    text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  }
  writeBeside("a.bin", kitti);
  expectRoom(load(outside(2, "a.bin")));
  writeBeside("a.txt", text);
  expectRoom(load(outside(3, "a.txt")));
}

TEST_F(ExternalFile, missingFilesAreNamedInOneLine) {
  const std::string text = errorOf(outside(1, "lidar_17.bin"));
  EXPECT_NE(text.find("1 of its 1 point clouds"), std::string::npos) << text;
  EXPECT_NE(text.find("lidar_17.bin"), std::string::npos) << text;
  EXPECT_NE(text.find("run_Images"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST_F(ExternalFile, damagedFilesBesideTheMapAreRefused) {
  writeBeside("a.bin", simple_.substr(0, 500));
  EXPECT_NE(errorOf(outside(1, "a.bin")).find("a.bin"), std::string::npos);
  writeBeside("a.bin", test::streamed(test::smallGrid()));
  EXPECT_NE(errorOf(outside(1, "a.bin")).find("COccupancyGridMap2D"), std::string::npos);
}

TEST(ExternalClouds, ofAllKindsGiveTheMapOfThoseInside) {
  const std::string archive = test::sharedFile("mrpt_new/external_clouds.tar.xz");
  if (archive.empty()) GTEST_SKIP() << "the runs are not beside the source tree";
  const TestFolder dir;
  const std::string command = "tar xJf '" + archive + "' -C '" + dir / "." + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const GreyMap inside = loadGrid(dir / "W0.simplemap", {});
  const auto greyOf = [&](const char* name) { return loadGrid(dir / name, {}).grey; };
  EXPECT_EQ(greyOf("W1.simplemap"), inside.grey);
  EXPECT_EQ(greyOf("W2.simplemap"), inside.grey);
  // Text has six digits, so a point on the edge of a cell may come to lie beside it.
  const auto ofText = greyOf("W3.simplemap");
  ASSERT_EQ(ofText.size(), inside.grey.size());
  std::size_t differ = 0;
  for (std::size_t i = 0; i < ofText.size(); ++i) differ += ofText[i] != inside.grey[i];
  EXPECT_LT(differ, ofText.size() / 1000) << differ;
}

TEST(SlicedRun, namesTheFilesThatAreMissing) {
  const std::string file = test::sharedFile("mrpt_new/v1_external_cloud.simplemap");
  if (file.empty()) GTEST_SKIP() << "the run is not there";
  const std::string text = test::refusalOf([&] { loadGrid(file, {}); });
  EXPECT_NE(text.find("lidar_0.bin"), std::string::npos) << text;
}

}  // namespace
}  // namespace roomgraph
