#include "roomgraph/map_files/load_grid.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPose3DPDFGaussianInf.h>
#include <mrpt/poses/CPose3DPDFParticles.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussianInf.h>
#include <mrpt/poses/CPosePDFParticles.h>

#include <cmath>

#include "TestFolder.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/base/Error.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::maps::CSimpleMap;

int greyOf(const GreyMap& map, int x, int y) { return map.grey[map.frame.index({x, y})]; }

void expectEqual(const GreyMap& map, const COccupancyGridMap2D& grid) {
  ASSERT_EQ(map.frame.width, int(grid.getSizeX()));
  ASSERT_EQ(map.frame.height, int(grid.getSizeY()));
  EXPECT_NEAR(map.frame.resolution, double(grid.getResolution()), 1e-6);
  EXPECT_NEAR(map.frame.origin.x, double(grid.getXMin()), 1e-5);
  EXPECT_NEAR(map.frame.origin.y, double(grid.getYMin()), 1e-5);
  for (int y = 0; y < map.frame.height; ++y)
    for (int x = 0; x < map.frame.width; ++x)
      ASSERT_EQ(greyOf(map, x, y), std::lround(255 * grid.getCell(x, y))) << x << " " << y;
}

/** The grid that MRPT builds, given the same room from the start. */
COccupancyGridMap2D builtByMrpt(const CSimpleMap& simplemap, const GreyMap& map,
                                const LoadGridOptions& options) {
  const auto& f = map.frame;
  COccupancyGridMap2D grid;
  grid.setSize(float(f.origin.x), float(f.origin.x + f.width * f.resolution), float(f.origin.y),
               float(f.origin.y + f.height * f.resolution), float(f.resolution));
  grid.insertionOptions.maxDistanceInsertion = float(options.maxDistanceInsertion);
  grid.insertionOptions.maxOccupancyUpdateCertainty = float(options.maxOccupancyUpdateCertainty);
  for (std::size_t i = 0; i < simplemap.size(); ++i) {
    const auto [pose, frame] = test::entryOf(simplemap, i);
    for (const auto& observation : *frame) grid.insertObservation(*observation, pose->getMeanVal());
  }
  return grid;
}

TEST(LoadGrid, gridmapEqualsWhatMrptReads) {
  const TestFolder dir;
  const auto grid = test::smallGrid();
  const GreyMap map = loadGrid(dir.write("a.gridmap", test::streamed(grid)), {});
  expectEqual(map, grid);
  EXPECT_DOUBLE_EQ(map.frame.resolution, 0.1);
  EXPECT_DOUBLE_EQ(map.frame.origin.x, -0.2);
  EXPECT_EQ(map.source.kind, "gridmap");
  EXPECT_EQ(map.source.insertion, "");
  EXPECT_TRUE(map.notes.empty());
}

TEST(LoadGrid, optionsThatAreOfNoUseAreNotedFirst) {
  const TestFolder dir;
  LoadGridOptions given;
  given.layer = "walls", given.isResolutionGiven = true;
  const std::string file = dir.write("a.gridmap", test::streamed(test::smallGrid()));
  const Notes notes = loadGrid(file, given).notes;
  ASSERT_EQ(notes.size(), 2u);
  for (const Note& note : notes) EXPECT_EQ(note.code, kUnusedOption);
  EXPECT_EQ(notes[0].text.rfind("--layer", 0), 0u) << notes[0].text;
  EXPECT_EQ(notes[1].text.rfind("--resolution", 0), 0u) << notes[1].text;
}

TEST(LoadGrid, unknownCellsLieBetweenTheThresholds) {
  const TestFolder dir;
  const COccupancyGridMap2D grid(0, 1, 0, 1, 0.1f);
  const GreyMap map = loadGrid(dir.write("a.gridmap", test::streamed(grid)), {});
  const double occupied = 1 - map.grey[0] / 255.0;
  EXPECT_LT(occupied, map.occupiedAbove);
  EXPECT_GT(occupied, map.freeBelow);
}

TEST(LoadGrid, nameSaysNothingAboutTheContent) {
  const TestFolder dir;
  const auto grid = test::smallGrid();
  const std::string bytes = test::streamed(grid);
  expectEqual(loadGrid(dir.write("a.png", bytes), {}), grid);
  expectEqual(loadGrid(dir.write("a.simplemap", test::gzipped(bytes)), {}), grid);
  expectEqual(loadGrid(dir.write("a.gridmap", test::gzipped(bytes)), {}), grid);
}

/** The stream of the small grid as an older MRPT would have written it. */
std::string oldStream(int version, const std::string& cells, const std::string& bits) {
  std::string bytes =
      "\x93"
      "COccupancyGridMap2D" +
      std::string(1, char(version)) + bits;
  bytes += test::raw<std::uint32_t>(2) + test::raw<std::uint32_t>(1);
  for (const float value : {0.f, 2.f, 0.f, 1.f, 1.f}) bytes += test::raw(value);
  return bytes + cells;
}

TEST(LoadGrid, gridmapsOfMrptsFirstVersionHoldProbabilities) {
  const TestFolder dir;
  const GreyMap map = loadGrid(dir.write("a", oldStream(0, "\x20\xe0", "") + "\x88"), {});
  ASSERT_EQ(map.grey.size(), 2u);
  EXPECT_EQ(map.grey[0],
            std::lround(255 * COccupancyGridMap2D::l2p(COccupancyGridMap2D::p2l(0x20 / 255.f))));
  EXPECT_NEAR(map.grey[1], 0xe0, 2);
}

TEST(LoadGrid, gridmapsOf16BitsKeepTheUpper8) {
  const TestFolder dir;
  const std::string options(4 + 1 + 4 + 4 + 1 + 2 + 4 + 29 + 12 + 9 + 8, '\0');
  const std::string cells = test::raw<std::int16_t>(-40 * 256 + 17) + test::raw<std::int16_t>(0);
  const std::string end = options + test::raw<std::uint32_t>(0) + std::string(2, '\0') + "\x88";
  const GreyMap map = loadGrid(dir.write("a", oldStream(3, cells, "\x10") + end), {});
  EXPECT_EQ(map.grey[0], std::lround(255 * COccupancyGridMap2D::l2p(-40)));
  EXPECT_EQ(map.grey[1], 128);
}

TEST(LoadGrid, simplemapEqualsWhatMrptBuilds) {
  const TestFolder dir;
  const auto simplemap = test::smallSimplemap();
  const LoadGridOptions options;
  const std::string bytes = test::streamed(simplemap);
  for (const auto& stored : {bytes, test::gzipped(bytes)}) {
    const GreyMap map = loadGrid(dir.write("a", stored), options);
    expectEqual(map, builtByMrpt(simplemap, map, options));
    EXPECT_EQ(map.source.kind, "simplemap");
    EXPECT_TRUE(map.notes.empty());
    // The room is in it, and not much more.
    EXPECT_TRUE(map.frame.contains(map.frame.cellAt({2, 2})));
    EXPECT_LT(map.frame.width * map.frame.resolution, 5);
  }
}

TEST(LoadGrid, insertionOptionsAreAppliedAndRecorded) {
  const TestFolder dir;
  const auto file = dir.write("a", test::streamed(test::smallSimplemap()));
  LoadGridOptions options;
  options.resolution = 0.125;
  options.maxDistanceInsertion = 1.5;
  const GreyMap map = loadGrid(file, options);
  EXPECT_EQ(map.frame.resolution, 0.125);
  EXPECT_NE(map.source.insertion.find("resolution = 0.125;"), std::string::npos);
  EXPECT_NE(map.source.insertion.find("max_distance_insertion = 1.5;"), std::string::npos);
  expectEqual(map, builtByMrpt(test::smallSimplemap(), map, options));
  EXPECT_NE(map.grey, loadGrid(file, {}).grey);
}

TEST(LoadGrid, simplemapsUnderTheirOldNameAreRead) {
  const TestFolder dir;
  std::string bytes = test::streamed(test::smallSimplemap());
  const GreyMap expected = loadGrid(dir.write("new", bytes), {});
  const std::size_t nameLength = bytes[0] & 0x7f;
  for (const std::string name : {"CSimpleMap", "CSensFrameProbSequence"}) {
    const std::string renamed =
        std::string(1, char(0x80 | name.size())) + name + bytes.substr(1 + nameLength);
    EXPECT_EQ(loadGrid(dir.write(name, renamed), {}).grey, expected.grey) << name;
  }
}

/** A simplemap of one entry, put together from its parts. */
std::string oneEntry(int version, const mrpt::serialization::CSerializable& pose,
                     const mrpt::obs::CSensoryFrame& frame) {
  return "\x8a"
         "CSimpleMap" +
         std::string(1, char(version)) + test::raw<std::uint32_t>(1) + test::streamed(pose) +
         test::streamed(frame) + "\x88";
}

TEST(LoadGrid, posesOfEveryCommonClassMeanTheSamePlace) {
  const TestFolder dir;
  const mrpt::poses::CPose3D place(0.5, -0.25, 0, 0.5, 0, 0);
  const mrpt::poses::CPose2D place2D(place);
  mrpt::poses::CPose3DPDFParticles particles3D(2);
  particles3D.resetDeterministic(place.asTPose());
  mrpt::poses::CPosePDFParticles particles2D(2);
  particles2D.resetDeterministic(place2D.asTPose());
  auto simplemap = test::smallSimplemap();
  const auto frame = test::entryOf(simplemap, 0).sf;

  const auto load = [&](int version, const mrpt::serialization::CSerializable& pose) {
    return loadGrid(dir.write("a", oneEntry(version, pose, *frame)), {});
  };
  const GreyMap expected = load(1, mrpt::poses::CPose3DPDFGaussian(place));
  EXPECT_EQ(load(1, mrpt::poses::CPose3DPDFGaussianInf(place)).grey, expected.grey);
  EXPECT_EQ(load(1, particles3D).grey, expected.grey);
  EXPECT_EQ(load(0, mrpt::poses::CPosePDFGaussian(place2D)).grey, expected.grey);
  EXPECT_EQ(load(0, mrpt::poses::CPosePDFGaussianInf(place2D)).grey, expected.grey);
  EXPECT_EQ(load(0, particles2D).grey, expected.grey);
}

TEST(LoadGrid, otherObservationsAreSteppedOverAndNoted) {
  const TestFolder dir;
  const auto expected = loadGrid(dir.write("a", test::streamed(test::smallSimplemap())), {});
  auto simplemap = test::smallSimplemap();
  const auto comment = mrpt::obs::CObservationComment::Create();
  comment->text = std::string("the mark of an end, \x88\x88, is no end in itself");
  for (std::size_t i = 0; i < simplemap.size(); ++i) {
    auto& frame = *test::entryOf(simplemap, i).sf;
    mrpt::obs::CSensoryFrame mixed;
    if (i != 1) mixed.insert(comment);
    mixed.insert(*frame.begin());
    if (i != 0) mixed.insert(mrpt::obs::CObservationOdometry::Create());
    frame = mixed;
  }
  const GreyMap map = loadGrid(dir.write("b", test::streamed(simplemap)), {});
  EXPECT_EQ(map.grey, expected.grey);
  ASSERT_EQ(map.notes.size(), 1u);
  EXPECT_EQ(map.notes[0].code, "other_observations");
  EXPECT_EQ(map.notes[0].text.substr(0, 2), "2 ") << "a comment is no sensor";
}

/** The simplemap after `change` of each of its scans. */
template <class Change>
std::string withScans(const Change& change) {
  auto simplemap = test::smallSimplemap();
  for (std::size_t i = 0; i < simplemap.size(); ++i)
    change(dynamic_cast<mrpt::obs::CObservation2DRangeScan&>(
        **test::entryOf(simplemap, i).sf->begin()));
  return test::streamed(simplemap);
}

/** The simplemap with scanners that look down by so many degrees. */
std::string tiltedScans(double degrees, double roll = 0) {
  return withScans([&](auto& scan) {
    scan.sensorPose = mrpt::poses::CPose3D(0, 0, 0.3, 0, degrees * M_PI / 180, roll);
  });
}

TEST(LoadGrid, scansThatAreSlightlyTiltedAreTakenForLevelAndNoted) {
  const TestFolder dir;
  for (const double roll : {0.0, M_PI}) {
    const GreyMap expected = loadGrid(dir.write("a", tiltedScans(0, roll)), {});
    const GreyMap map = loadGrid(dir.write("b", tiltedScans(2.5, roll)), {});
    EXPECT_EQ(map.grey, expected.grey);
    EXPECT_TRUE(expected.notes.empty());
    ASSERT_EQ(map.notes.size(), 1u);
    EXPECT_EQ(map.notes[0].code, "tilted_scans");
    EXPECT_NE(map.notes[0].text.find("2.5 degrees"), std::string::npos) << map.notes[0].text;
  }
}

TEST(LoadGrid, aNegativeFieldOfViewRunsTheOtherWay) {
  const TestFolder dir;
  const auto bytes = [](float aperture, bool rightToLeft) {
    return withScans([&](auto& scan) { scan.aperture = aperture, scan.rightToLeft = rightToLeft; });
  };
  const GreyMap expected = loadGrid(dir.write("a", bytes(2.5f, false)), {});
  EXPECT_EQ(loadGrid(dir.write("b", bytes(-2.5f, true)), {}).grey, expected.grey);
  EXPECT_NE(loadGrid(dir.write("c", bytes(2.5f, true)), {}).grey, expected.grey);
  EXPECT_THROW(loadGrid(dir.write("d", bytes(-7.5f, true)), {}), DataError);
}

TEST(LoadGrid, scansThatAreTiltedAreRefusedAsSuch) {
  const TestFolder dir;
  const std::string file = dir.write("a", tiltedScans(4));
  const std::string text = test::refusalOf([&] { loadGrid(file, {}); });
  EXPECT_NE(text.find("only 3 CObservation2DRangeScan that are tilted"), std::string::npos) << text;
}

TEST(LoadGrid, aSliceOfScansIsRefusedAsSuch) {
  const TestFolder dir;
  LoadGridOptions options;
  options.sliceLow = 0.5, options.sliceHigh = 1;
  const std::string text =
      test::refusalOf([&] { loadGrid(dir.write("a", tiltedScans(0)), options); });
  EXPECT_NE(text.find("leave --slice out"), std::string::npos) << text;
}

TEST(LoadGrid, aScanThatDoesNotSurroundItsSensorStaysInsideTheGrid) {
  const TestFolder dir;
  const std::string narrow = withScans([](auto& scan) {
    scan.aperture = 0.1f;
    for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRange(i, 25);
  });
  const GreyMap map = loadGrid(dir.write("a", narrow), {});
  EXPECT_TRUE(map.frame.contains(map.frame.cellAt({-0.5, 0})));
  EXPECT_TRUE(map.frame.contains(map.frame.cellAt({25.5, 0})));
  EXPECT_GT(map.grey[map.frame.index(map.frame.cellAt({-0.3, 0}))], 128);
}

TEST(LoadGrid, picturesStandOnTheirLowestRow) {
  const TestFolder dir;
  LoadGridOptions options;
  options.resolution = 0.25;
  const std::string pixels = {0, 10, 20, 30, 40, char(250)};
  for (const auto& bytes : {test::png(3, 2, 1, pixels), "P5\n# a comment\n3 2\n255\n" + pixels,
                            std::string("P2 3 2 255\n0 10 20\n30 40 250")}) {
    const GreyMap map = loadGrid(dir.write("a", bytes), options);
    ASSERT_EQ(map.frame.width, 3);
    ASSERT_EQ(map.frame.height, 2);
    EXPECT_EQ(map.grey, (std::vector<std::uint8_t>{30, 40, 250, 0, 10, 20}));
    EXPECT_EQ(map.frame.resolution, 0.25);
    EXPECT_EQ(map.frame.origin.x, 0);
    EXPECT_EQ(map.frame.origin.y, 0);
    EXPECT_EQ(map.source.kind, "image");
  }
}

TEST(LoadGrid, colourIsAveragedAndTransparencyIsMidGrey) {
  const TestFolder dir;
  const std::string rgb = {0, 100, char(200), char(255), char(255), char(255)};
  EXPECT_EQ(loadGrid(dir.write("a", test::png(2, 1, 3, rgb)), {}).grey,
            (std::vector<std::uint8_t>{100, 255}));
  const std::string clear = {0, 0, char(255), 0, 0, char(255)};
  EXPECT_EQ(loadGrid(dir.write("a", test::png(3, 1, 2, clear)), {}).grey,
            (std::vector<std::uint8_t>{128, 128, 0}));
}

TEST(LoadGrid, pgmsOfOtherDepthsAreScaled) {
  const TestFolder dir;
  EXPECT_EQ(loadGrid(dir.write("a", "P2 3 1 15 0 5 15"), {}).grey,
            (std::vector<std::uint8_t>{0, 85, 255}));
  EXPECT_EQ(loadGrid(dir.write("a", std::string("P5 2 1 65535\n\x80\x80\xff\xff", 17)), {}).grey,
            (std::vector<std::uint8_t>{128, 255}));
}

class RosMap : public testing::Test {
 protected:
  GreyMap load(const std::string& more) {
    dir_.write("map.pgm", "P2 4 1 255 0 100 205 254");
    return loadGrid(dir_.write("map.yaml", "image: map.pgm\nresolution: 0.05\n" + more), {});
  }
  TestFolder dir_;
};

TEST_F(RosMap, yamlSaysWhereThePictureLiesAndHowToReadIt) {
  const GreyMap map =
      load("origin: [-1.5, 2.25, 0.0]\nnegate: 0\noccupied_thresh: 0.7\nfree_thresh: 0.2\n");
  EXPECT_EQ(map.source.kind, "ros_map");
  EXPECT_EQ(map.frame.resolution, 0.05);
  EXPECT_EQ(map.frame.origin.x, -1.5);
  EXPECT_EQ(map.frame.origin.y, 2.25);
  EXPECT_EQ(map.occupiedAbove, 0.7);
  EXPECT_EQ(map.freeBelow, 0.2);
  EXPECT_EQ(map.grey, (std::vector<std::uint8_t>{0, 100, 205, 254}));
}

TEST_F(RosMap, negateTurnsLightToDark) {
  EXPECT_EQ(load("origin: [0, 0, 0]\nnegate: 1\n").grey,
            (std::vector<std::uint8_t>{255, 155, 50, 1}));
  EXPECT_EQ(load("origin: [0, 0, 0]\nnegate: true\n").grey[0], 255);
}

TEST_F(RosMap, rawPixelsArePercentsOccupied) {
  EXPECT_EQ(load("origin: [0, 0, 0]\nmode: raw\n").grey,
            (std::vector<std::uint8_t>{255, 0, 128, 128}));
}

TEST_F(RosMap, hashChangesWithThePicture) {
  const std::string rest = "origin: [0, 0, 0]\n";
  const std::string before = load(rest).source.sha256;
  EXPECT_EQ(load(rest).source.sha256, before);
  const auto yaml = "image: map.pgm\nresolution: 0.05\n" + rest;
  dir_.write("map.pgm", "P2 4 1 255 0 100 205 253");
  EXPECT_NE(loadGrid(dir_.write("map.yaml", yaml), {}).source.sha256, before);
}

TEST(LoadGrid, hashIsThatOfTheStoredBytes) {
  const TestFolder dir;
  EXPECT_EQ(loadGrid(dir.write("a", "P2 1 1 255 7\n"), {}).source.sha256,
            "4cf2bfbbfd33abf08aec5ee36dbc3c3f2f97aa8a9b9dff1108612e22968758eb");
}

TEST(LoadGrid, optionsHaveSensibleRanges) {
  LoadGridOptions options;
  FieldTable table;
  describe(options, table);
  EXPECT_EQ(table.fields().size(), 7u);
  table.set("load_grid", "resolution", "0.1");
  EXPECT_EQ(options.resolution, 0.1);
  EXPECT_THROW(table.set("load_grid", "resolution", "0"), UsageError);
  EXPECT_THROW(table.set("load_grid", "max_distance_insertion", "inf"), UsageError);
}

}  // namespace
}  // namespace roomgraph
