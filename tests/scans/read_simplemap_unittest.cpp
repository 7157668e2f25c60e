#include <gtest/gtest.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include "TestFolder.h"
#include "map_files.h"
#include "newer_simplemap.h"
#include "refusal.h"
#include "roomgraph/map_files/load_grid.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

using test::Newer;

class NewerSimplemap : public testing::Test {
 protected:
  GreyMap load(const std::string& bytes) const {
    return loadGrid(dir_.write("map.simplemap", bytes), {});
  }
  std::string errorOf(const std::string& bytes) const {
    return test::refusalOf([&] { load(bytes); });
  }
  void expectSameGrid(const std::string& bytes) const {
    const GreyMap map = load(bytes);
    EXPECT_EQ(map.grey, old_.grey);
    EXPECT_EQ(map.frame.origin.x, old_.frame.origin.x);
    EXPECT_EQ(map.frame.origin.y, old_.frame.origin.y);
  }

  const TestFolder dir_;
  const mrpt::maps::CSimpleMap simplemap_ = test::smallSimplemap();
  const GreyMap old_ = load(test::streamed(simplemap_));
};

TEST_F(NewerSimplemap, givesTheSameGridInEveryVersionAndCompression) {
  for (const int mapVersion : {1, 2})
    for (const int scanVersion : {7, 8})
      for (const bool hasTwist : {false, true})
        for (const bool hasComments : {false, true}) {
          SCOPED_TRACE(testing::Message() << mapVersion << scanVersion << hasTwist << hasComments);
          Newer how{mapVersion, hasTwist, scanVersion, hasComments, false};
          const std::string bytes = test::asNewer(simplemap_, how);
          expectSameGrid(bytes);
          expectSameGrid(test::gzipped(bytes));
          expectSameGrid(test::zstd(bytes, true));
          expectSameGrid(test::zstd(bytes, false));
        }
}

TEST_F(NewerSimplemap, framesWithoutObservationsAreLegal) {
  for (const int mapVersion : {1, 2})
    for (const bool hasComments : {false, true})
      expectSameGrid(test::asNewer(simplemap_, {mapVersion, true, 8, hasComments, true}));
}

TEST_F(NewerSimplemap, observationsOfOtherSensorsAreSteppedOver) {
  mrpt::obs::CObservationIMU imu;
  imu.dataIsPresent[0] = true;
  imu.rawMeasurements.fill(-2e-9);
  const mrpt::obs::CObservationGPS gps;
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < simplemap_.size(); ++i) {
    const auto [pose, frame] = test::entryOf(simplemap_, i);
    const std::string scan = test::streamed(**frame->begin());
    entries.push_back(test::streamed(*pose) +
                      test::frameBytes({test::streamed(gps), scan, test::streamed(imu)}) +
                      test::twistBytes(i == 1));
  }
  expectSameGrid(test::simplemapBytes(2, entries));
}

TEST_F(NewerSimplemap, scansKeepTheirIdentityInEveryVersion) {
  const auto before = loadMap(dir_.write("old", test::streamed(simplemap_)), {}).keyframes;
  const auto after = loadMap(dir_.write("new", test::asNewer(simplemap_, {})), {}).keyframes;
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].scanId, after[i].scanId);
    EXPECT_EQ(before[i].time, after[i].time);
  }
}

TEST_F(NewerSimplemap, cutAnywhereItIsRefused) {
  const std::string bytes = test::asNewer(simplemap_, {2, true, 8, true, true});
  const std::string zstd = test::zstd(bytes, false);
  for (const std::string& whole : {bytes, zstd})
    for (std::size_t size = 1; size < whole.size(); size += 3)
      EXPECT_NE(errorOf(whole.substr(0, size)), "") << size << " of " << whole.size();
  EXPECT_NE(errorOf(bytes.substr(0, bytes.size() - 1)), "");
  EXPECT_NE(errorOf(zstd.substr(0, zstd.size() - 1)), "");
}

TEST_F(NewerSimplemap, liesAboutTheTwistAreRefused) {
  const auto [pose, frame] = test::entryOf(simplemap_, 0);
  const std::string start = test::streamed(*pose) + test::streamed(*frame);
  const std::string twist = test::twistBytes(true);
  for (const std::string& behind : {std::string(), twist.substr(0, 17), "x" + twist, twist + "x",
                                    test::raw(0xffffffffu) + twist.substr(4)})
    EXPECT_NE(errorOf(test::simplemapBytes(2, {start + behind})), "");
  std::string longName = twist;
  longName.replace(17, 4, test::raw(0xfffffff0u));
  EXPECT_NE(errorOf(test::simplemapBytes(2, {start + longName})), "");
}

TEST_F(NewerSimplemap, versionsStillToComeAreNamedWithAWayForward) {
  const std::string text = errorOf(test::asNewer(simplemap_, {3, false, 8, false, false}));
  EXPECT_NE(text.find("version 3 of CSimpleMap"), std::string::npos) << text;
  EXPECT_NE(text.find("0 to 2"), std::string::npos) << text;
  EXPECT_NE(text.find("ROS map"), std::string::npos) << text;
}

TEST_F(NewerSimplemap, damagedZstdIsRefused) {
  const std::string bytes = test::asNewer(simplemap_, {});
  const std::string sealed = test::zstd(bytes, true);
  std::size_t harmless = 0;  // a bit that says nothing
  for (std::size_t i = 4; i < sealed.size(); i += 5) {
    std::string changed = sealed;
    changed[i] = char(changed[i] ^ 0x10);
    if (!errorOf(changed).empty()) continue;
    expectSameGrid(changed);
    ++harmless;
  }
  EXPECT_LT(harmless, 6u);
  EXPECT_NE(errorOf(sealed + "x").find("something follows"), std::string::npos);
  EXPECT_NE(errorOf(sealed + sealed).find("something follows"), std::string::npos);
  EXPECT_NE(errorOf(test::zstd("", true)).find("is empty"), std::string::npos);
}

TEST_F(NewerSimplemap, zstdThatInflatesWithoutEndIsRefused) {
  // A frame without a stated size whose blocks each repeat one byte 128 KiB times.
  std::string bytes = std::string("\x28\xb5\x2f\xfd", 4) + std::string("\x00\x58", 2);
  const std::uint32_t repeated = (1u << 17) << 3 | 1u << 1;
  for (int i = 0; i < 20'000; ++i) bytes += test::raw(repeated).substr(0, 3) + 'x';
  EXPECT_NE(errorOf(bytes).find("more than 2 GB"), std::string::npos);
}

TEST_F(NewerSimplemap, whatMrptWritesTodayGivesTheGridOfTheOldFile) {
  const std::string original = "/usr/share/mrpt/datasets/malaga-cs-fac-building.simplemap.gz";
  if (test::sharedFile("mrpt_new/v1_zstd.simplemap").empty() || !test::isFile(original))
    GTEST_SKIP() << "the files of newer versions, or MRPT's, are not there";
  const GreyMap expected = loadGrid(original, {});
  for (const std::string name :
       {"v1_zstd", "v2_no_twist", "v2_twist", "v2_twist_scan8", "v2_scan8_comment"}) {
    const GreyMap map = loadGrid(test::sharedFile("mrpt_new/" + name + ".simplemap"), {});
    EXPECT_TRUE(map.grey == expected.grey) << name;
    EXPECT_EQ(map.frame.origin.x, expected.frame.origin.x);
    EXPECT_EQ(map.frame.origin.y, expected.frame.origin.y);
  }
}

TEST(NewerGridmap, hasTheLayoutOfTheOneBefore) {
  const TestFolder dir;
  std::string bytes = test::streamed(test::smallGrid());
  const GreyMap old = loadGrid(dir.write("old", bytes), {});
  bytes[1 + (bytes[0] & 0x7f)] = 7;
  EXPECT_EQ(loadGrid(dir.write("new", test::zstd(bytes, false)), {}).grey, old.grey);
}

TEST(NewerGridmap, ofMrpt3IsRead) {
  const std::string file = test::sharedFile("mrpt_new/gridmap_v7.gridmap");
  if (file.empty()) GTEST_SKIP() << "the gridmap of MRPT 3 is not beside the source tree";
  const GreyMap map = loadGrid(file, {});
  EXPECT_EQ(map.frame.width, 600);
  EXPECT_EQ(map.frame.height, 700);
}

}  // namespace
}  // namespace roomgraph
