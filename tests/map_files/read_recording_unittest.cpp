#include "roomgraph/map_files/read_recording.h"

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "drawn_cloud.h"
#include "map_files.h"
#include "readings.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/map_files/map_formats.h"
#include "roomgraph/scans/place_scans.h"

namespace roomgraph {
namespace {

using test::readings;

class ReadOnce : public testing::Test {
 protected:
  std::string scans() const {
    return dir_.write("scans", test::gzipped(test::streamed(test::smallSimplemap())));
  }
  /** A simplemap with one cloud. */
  std::string cloud() const {
    const std::string points =
        test::pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, test::roomPoints(), "");
    return dir_.write("cloud",
                      test::oneObservation(test::cloudBytes({0, 0, 0.5, 0, 0, 0}, '\0' + points)));
  }

  const TestFolder dir_;
};

TEST_F(ReadOnce, eachScanIsDecodedOnceForGridAndKeyFrames) {
  const std::string file = scans();
  readings = {};
  const LoadedMap read = loadMap(file, {});
  EXPECT_EQ(readings.files, 1u);
  EXPECT_EQ(readings.scans, 3u);
  EXPECT_EQ(read.keyframes.size(), 3u);
  EXPECT_EQ(read.map.grey, loadGrid(file, {}).grey);
}

TEST_F(ReadOnce, eachCloudIsDecodedOnceAndOnlyForItsSlice) {
  const std::string file = cloud();
  readings = {};
  ASSERT_TRUE(readRecording(file));
  EXPECT_EQ(readings.clouds, 0u) << "what a run holds is told without its points";
  const LoadedMap read = loadMap(file, {});
  EXPECT_EQ(readings.clouds, 1u);
  EXPECT_EQ(readings.files, 2u);
  EXPECT_EQ(read.keyframes.size(), 1u);
}

TEST_F(ReadOnce, cloudsThatThereIsNoRoomForGiveTheSameSlices) {
  const auto recording = readRecording(cloud());
  readings = {};
  const PlacedScans kept = placeScans(*recording, {}), again = placeScans(*recording, {}, 0);
  EXPECT_EQ(readings.clouds, 3u);
  ASSERT_EQ(kept.scans.size(), 1u);
  ASSERT_EQ(again.scans.size(), 1u);
  EXPECT_EQ(kept.scans[0].scan.ranges, again.scans[0].scan.ranges);
  EXPECT_EQ(kept.scans[0].id, again.scans[0].id);
}

TEST_F(ReadOnce, everyFormatHasAGridOrScans) {
  for (const MapFormat& format : mapFormats())
    EXPECT_TRUE(format.readGrid || format.readRecording) << format.kind;
}

TEST(ReadRecording, otherMapsHaveNone) {
  const TestFolder dir;
  EXPECT_FALSE(readRecording(dir.write("map", test::streamed(test::smallGrid()))));
  EXPECT_FALSE(readRecording(dir.write("map", "P2 1 1 255 7\n")));
}

TEST(ReadRecording, damageIsRefused) {
  const TestFolder dir;
  const std::string bytes = test::streamed(test::smallSimplemap());
  EXPECT_THROW(readRecording(dir.write("map", bytes.substr(0, 900))), DataError);
  EXPECT_THROW(readRecording(dir / "none"), DataError);
}

}  // namespace
}  // namespace roomgraph
