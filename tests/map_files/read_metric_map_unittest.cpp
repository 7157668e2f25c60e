#include <gtest/gtest.h>

#include <cmath>

#include "TestFolder.h"
#include "drawn_cloud.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/grid/binarize.h"
#include "roomgraph/map_files/load_grid.h"
#include "sampled_grid.h"

namespace roomgraph {
namespace {

using test::raw;

std::string text(const std::string& characters) {
  return raw(std::uint32_t(characters.size())) + characters;
}

/** A metric map of the layers, each a name and the bytes of its object. */
std::string metricMap(int version, const std::vector<std::pair<std::string, std::string>>& layers,
                      const std::string& features = std::string(12, '\0')) {
  const std::string name = "mp2p_icp::metric_map_t";
  std::string bytes = std::string(1, char(0x80 | name.size())) + name + char(version) +
                      text("std::vector") + text("TLine3D") + features +
                      raw(std::uint32_t(layers.size()));
  for (const auto& [layer, object] : layers) bytes += text(layer) + object;
  if (version >= 1)
    bytes += text("std::optional") + text("uint64_t") + '\1' + raw<std::uint64_t>(7) +
             text("std::optional") + text("std::string") + '\0';
  if (version >= 5) bytes += '\1' + text("site: lab\n");
  return bytes + "\x88";
}

class MetricMap : public testing::Test {
 protected:
  GreyMap load(const std::string& bytes, const std::string& layer = {}) const {
    LoadGridOptions options;
    options.layer = layer;
    return loadGrid(dir_.write("map.mm", bytes), options);
  }
  std::string errorOf(const std::string& bytes, const std::string& layer = {}) const {
    return test::refusalOf([&] { load(bytes, layer); });
  }
  const TestFolder dir_;
  const std::string grid_ = test::streamed(test::smallGrid());
  const std::string points_ = test::pointsMapBytes("mrpt::maps::CSimplePointsMap", 10,
                                                   test::roomPoints(), std::string(9, '\x88'));
  const std::string voxels_ = "\x95mrpt::maps::CVoxelMap\1" + std::string(40, '\x88');
};

TEST_F(MetricMap, itsGridLayerIsReadInEveryVersion) {
  const GreyMap expected = loadGrid(dir_.write("a.gridmap", grid_), {});
  for (int version = 0; version <= 5; ++version) {
    const std::string bytes =
        metricMap(version, {{"raw", points_}, {"odd", voxels_}, {"gridmap", grid_}});
    for (const std::string& stored : {bytes, test::gzipped(bytes), test::zstd(bytes, false)}) {
      const GreyMap map = load(stored);
      EXPECT_EQ(map.grey, expected.grey) << version;
      EXPECT_EQ(map.frame.origin.x, expected.frame.origin.x);
      EXPECT_EQ(map.source.kind, "metric_map");
    }
  }
}

TEST_F(MetricMap, linesAndPlanesAreSteppedOver) {
  const std::string features = raw(2u) + std::string(96, '\x88') + raw(1u) +
                               std::string(56, '\x88') + raw(2u) + std::string(96, '\x88');
  EXPECT_EQ(load(metricMap(3, {{"gridmap", grid_}}, features)).frame.width, 5);
}

/** The walls of the room are in the map, within a cell, and nothing else is. */
void expectRoom(const GreyMap& map) {
  const Grid grid = binarize(map, {});
  const auto walls = test::occupiedPlaces(grid);
  for (const Point p : walls) EXPECT_NEAR(std::max(std::abs(p.x), std::abs(p.y)), 2, 0.08);
  EXPECT_GT(walls.size(), 250u);
  EXPECT_TRUE(grid.isFree({0.5, 0.5}));
  EXPECT_FALSE(grid.isFree({2.3, 0}));
}

TEST_F(MetricMap, pointsAreSlicedAndTheirFloorIsFree) {
  const GreyMap map = load(metricMap(3, {{"raw", points_}}));
  expectRoom(map);
  ASSERT_EQ(map.notes.size(), 1u);
  EXPECT_EQ(map.notes[0].code, "slice");
}

TEST_F(MetricMap, aLayerIsReadByItsName) {
  const std::string bytes = metricMap(3, {{"raw", points_}, {"gridmap", grid_}});
  EXPECT_EQ(load(bytes, "gridmap").frame.width, 5);
  EXPECT_GT(load(bytes, "raw").frame.width, 50);
  const std::string text = errorOf(bytes, "walls");
  EXPECT_NE(text.find("'walls'"), std::string::npos) << text;
  EXPECT_NE(text.find("gridmap (COccupancyGridMap2D)"), std::string::npos) << text;
  EXPECT_NE(errorOf(metricMap(3, {{"odd", voxels_}}), "odd").find("CVoxelMap"), std::string::npos);
}

TEST_F(MetricMap, withoutGridOrFloorItSaysWhatIsMissing) {
  EXPECT_NE(errorOf(metricMap(3, {{"odd", voxels_}})).find("no layer with a grid or points"),
            std::string::npos);
  EXPECT_NE(errorOf(metricMap(3, {})).find("none"), std::string::npos);
  test::Points flat;
  for (int i = 0; i < 100; ++i) flat.emplace_back(float(i) * 0.1f, 1.f, 0.16f);
  const std::string lidar = test::pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, flat, "");
  EXPECT_NE(errorOf(metricMap(1, {{"2d_lidar", lidar}})).find("one height only"),
            std::string::npos);
}

TEST_F(MetricMap, wallsWithoutFloorAreRefused) {
  test::Points walls;
  for (const auto& p : test::roomPoints())
    if (p.z > -0.35f) walls.push_back(p);
  const std::string layer = test::pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, walls, "");
  const std::string text = errorOf(metricMap(5, {{"walls", layer}}));
  EXPECT_NE(text.find("walls only: without a floor"), std::string::npos) << text;
}

TEST_F(MetricMap, layersWithShortClassNamesAreSteppedOver) {
  const std::string ndt = "\x89mola::NDT\1" + std::string(40, '\x88');
  const std::string text =
      errorOf(metricMap(5, {{"local", voxels_}, {"ndt", ndt}, {"z", voxels_}}));
  EXPECT_NE(text.find("local (CVoxelMap), ndt (NDT), z (CVoxelMap)"), std::string::npos) << text;
}

TEST_F(MetricMap, ofSeveralLayersOfPointsOneWithPointsIsRead) {
  const std::string none = test::pointsMapBytes("mrpt::maps::CSimplePointsMap", 10, {}, "");
  EXPECT_GT(load(metricMap(5, {{"a", none}, {"b", points_}})).frame.width, 50);
  EXPECT_NE(errorOf(metricMap(5, {{"a", none}})).find("'a' has no points"), std::string::npos);
}

/** MOLA's map of key frames, each with its cloud; seven bytes stand for its options. */
std::string keyframeMap(int version, const std::vector<mrpt::poses::CPose3D>& poses,
                        const test::Points& points) {
  std::string bytes = "\x9bmola::KeyframePointCloudMap" + std::string(1, char(version)) +
                      std::string(7, '\x88') + raw(std::uint32_t(poses.size()));
  std::uint64_t number = 0;
  for (const auto& pose : poses) {
    const auto seen = test::seenFrom(pose, points);
    bytes += raw(number++) + raw<std::uint64_t>(1) + test::streamed(pose) + '\1' +
             test::pointsMapBytes("mrpt::maps::CGenericPointsMap", 4, seen, std::string(9, '\x88'));
    if (version >= 2) bytes += '\1' + text("a tree\x88");
    if (version >= 3) bytes += '\0';
  }
  return bytes + "\x88";
}

TEST_F(MetricMap, cloudsOfKeyframesArePutTogether) {
  // Number 12 and what follows it look like a name of 12 bytes and an object.
  std::vector<mrpt::poses::CPose3D> poses;
  for (int i = 0; i < 14; ++i) poses.emplace_back(0.5 * i, -0.25 * i, 0, 0.5 * i, 0.1, 0);
  for (const int version : {0, 1, 2, 3}) {
    const std::string layer = keyframeMap(version, poses, test::roomPoints());
    SCOPED_TRACE(version);
    expectRoom(load(metricMap(5, {{"local", layer}, {"odd", voxels_}})));
  }
  EXPECT_NE(errorOf(metricMap(5, {{"local", keyframeMap(3, {}, {})}})).find("no points"),
            std::string::npos);
}

TEST_F(MetricMap, cloudsThatGrowAreReadAsThePointsInThem) {
  const std::string layer = "\x9bmola::IncrementalPointCloud\1" + points_ + "options\x88";
  const GreyMap map = load(metricMap(5, {{"local", layer}, {"odd", voxels_}}));
  EXPECT_EQ(map.grey, load(metricMap(5, {{"raw", points_}})).grey);
}

TEST_F(MetricMap, cutsAndLiesAreRefused) {
  const std::string bytes = metricMap(3, {{"raw", points_}, {"gridmap", grid_}});
  for (std::size_t size = 1; size < bytes.size() - 200; size += 1 + size / 8)
    EXPECT_NE(errorOf(bytes.substr(0, size)), "") << size;
  for (const std::uint32_t count : {0xffffffffu, 100'000u}) {
    EXPECT_NE(errorOf(metricMap(3, {{"gridmap", grid_}}, raw(count) + std::string(8, '\0'))), "");
    std::string layers = metricMap(3, {{"gridmap", grid_}});
    layers.replace(layers.find(raw(1u) + text("gridmap")), 4, raw(count));
    EXPECT_NE(errorOf(layers), "");
  }
  EXPECT_NE(errorOf(metricMap(6, {{"gridmap", grid_}})).find("only 0 to 5 are known"),
            std::string::npos);
}

TEST_F(MetricMap, whatMolaWroteGivesTheGridInIt) {
  const std::string file = test::sharedFile("mrpt_new/mvsim-warehouse01.mm");
  const std::string layer = test::sharedFile("mrpt_new/warehouse_layer_of_mm.gridmap");
  if (file.empty() || layer.empty()) GTEST_SKIP() << "MOLA's maps are not beside the source tree";
  const GreyMap map = loadGrid(file, {}), expected = loadGrid(layer, {});
  EXPECT_EQ(map.grey, expected.grey);
  EXPECT_EQ(map.frame.origin.x, expected.frame.origin.x);
  EXPECT_EQ(map.frame.resolution, expected.frame.resolution);
  EXPECT_THROW(loadGrid(test::sharedFile("mrpt_new/local_001.mm"), {}), DataError);
}

}  // namespace
}  // namespace roomgraph
