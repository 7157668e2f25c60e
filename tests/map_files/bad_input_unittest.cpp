#include <gtest/gtest.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "TestFolder.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/map_files/load_grid.h"
#include "simplemap_entry.h"

namespace roomgraph {
namespace {

using test::raw;

/** The message that loading the file ends with; empty if it can be loaded. */
std::string errorOf(const std::string& file, const LoadGridOptions& options = {}) {
  return test::refusalOf([&] { loadGrid(file, options); });
}

/** One line of the form "FILE: problem: remedy", with `part` in it and nothing of MRPT's. */
void expectError(const std::string& file, const std::string& part = {},
                 const LoadGridOptions& options = {}) {
  const std::string text = errorOf(file, options);
  ASSERT_NE(text, "") << "was loaded";
  EXPECT_EQ(text.compare(0, file.size() + 2, file + ": "), 0) << text;
  EXPECT_NE(text.find(": ", file.size() + 2), std::string::npos) << text;
  EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' '; })) << text;
  EXPECT_LT(text.size(), file.size() + 200) << text;
}

class BadInput : public testing::Test {
 protected:
  std::string write(const std::string& bytes) const { return dir_.write("map", bytes); }
  void expectRefused(const std::string& bytes, const std::string& part = {}) const {
    expectError(write(bytes), part);
  }
  /** Every beginning of `bytes`, down to a single byte. */
  void expectEveryCutRefused(const std::string& bytes) const {
    ASSERT_EQ(errorOf(write(bytes)), "");
    for (std::size_t size = bytes.size() - 1; size > 0; --size) {
      expectRefused(bytes.substr(0, size));
      if (HasFailure()) FAIL() << "cut after " << size << " of " << bytes.size() << " bytes";
    }
  }
  TestFolder dir_;
};

TEST_F(BadInput, missingFileIsRefused) {
  expectError(dir_ / "none.gridmap", "there is no such file");
}

TEST_F(BadInput, directoryIsRefused) { expectError(dir_ / ".", "is a directory"); }

TEST_F(BadInput, deviceIsRefused) { expectError("/dev/null", "is a pipe or a device"); }

TEST_F(BadInput, emptyFileIsRefused) {
  expectRefused("", "is empty");
  expectRefused(test::gzipped(""), "is empty");
}

TEST_F(BadInput, textIsRefused) {
  expectRefused("Dear map,\nhow are you?\n", "is not a map of a known kind");
  expectRefused(std::string(60000, '['), "is not a map of a known kind");
  expectRefused("key: value\n", "is not a map of a known kind");
}

TEST_F(BadInput, whatOtherProgramsOpenIsNamed) {
  expectRefused("{\n \"format\": \"roomgraph/comparison\", \"runs\": []}", "roomgraph-view");
  expectRefused("{\"format\": \"roomgraph/graph\"}", "the map that it is of");
  expectRefused(test::gzipped("\x8a"
                              "CRoomGraph" +
                              std::string(99, '\0')),
                "RawLogViewer");
  expectRefused(test::gzipped("\x8e"
                              "CMapComparison" +
                              std::string(99, '\0')),
                "is a comparison");
  expectRefused("\x93mrpt::opengl::Scene" + std::string(99, '\0'), "SceneViewer3D");
  expectRefused("{\"format\": \"something\"}", "is not a map of a known kind");
}

TEST_F(BadInput, randomBytesAreRefused) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    std::string bytes(1 + random() % 500, '\0');
    for (char& c : bytes) c = char(random());
    expectRefused(bytes);
    expectRefused(test::gzipped(bytes));
    expectRefused("\x1f\x8b\x08" + bytes);
    expectRefused(
        "\x8a"
        "CSimpleMap\x01" +
        bytes);
    expectRefused(
        "\x93"
        "COccupancyGridMap2D\x06" +
        bytes);
  }
}

TEST_F(BadInput, strangeFileNamesStayOneLine) {
  const std::string text = errorOf(dir_.write("a\nb", "junk"));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_NE(text.find("a?b"), std::string::npos);
}

TEST_F(BadInput, gridmapCutAnywhereIsRefused) {
  const std::string bytes = test::streamed(test::smallGrid());
  expectEveryCutRefused(bytes);
  expectEveryCutRefused(test::gzipped(bytes));
}

TEST_F(BadInput, simplemapCutAnywhereIsRefused) {
  const std::string bytes = test::streamed(test::smallSimplemap());
  expectEveryCutRefused(bytes);
  expectEveryCutRefused(test::gzipped(bytes));
}

TEST_F(BadInput, simplemapWithUnknownObservationsCutAnywhereIsRefused) {
  auto simplemap = test::smallSimplemap();
  for (std::size_t i = 0; i < simplemap.size(); ++i)
    test::entryOf(simplemap, i).sf->insert(mrpt::obs::CObservationOdometry::Create());
  expectEveryCutRefused(test::streamed(simplemap));
}

TEST_F(BadInput, pictureCutAnywhereIsRefused) {
  std::string pixels(20 * 10, '\0');
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = char(i * 37);
  expectEveryCutRefused(test::png(20, 10, 1, pixels));
  expectEveryCutRefused("P5\n20 10\n255\n" + pixels);
  expectEveryCutRefused(test::gzipped("P5\n20 10\n255\n" + pixels));
}

TEST_F(BadInput, somethingAfterTheMapIsRefused) {
  const std::string pixels(6, '\x70');
  for (const auto& bytes :
       {test::streamed(test::smallGrid()), test::streamed(test::smallSimplemap()),
        test::png(3, 2, 1, pixels), "P5 3 2 255\n" + pixels, std::string("P2 1 1 255 7\n")}) {
    ASSERT_EQ(errorOf(write(bytes)), "");
    expectRefused(bytes + "x", "something follows");
    expectRefused(bytes + bytes, "something follows");
    expectRefused(test::gzipped(bytes + "x"), "something follows");
    expectRefused(test::gzipped(bytes) + "x");
    expectRefused(test::gzipped(bytes) + test::gzipped(bytes), "something follows");
  }
}

TEST_F(BadInput, wrongChecksumIsRefused) {
  std::string bytes = test::gzipped(test::streamed(test::smallGrid()));
  bytes[bytes.size() - 6] ^= 1;
  expectRefused(bytes, "gzip data");
  std::string png = test::png(1, 1, 1, "x");
  png[png.size() - 13] ^= 1;
  expectRefused(png, "checksum");
}

/** Changed bytes may give another map, but nothing worse. */
TEST_F(BadInput, anyChangedByteEitherLoadsOrIsRefused) {
  int refused = 0;
  LoadGridOptions coarse;  // for poses that end up far away
  coarse.resolution = 10;
  for (const auto& bytes :
       {test::streamed(test::smallGrid()), test::streamed(test::smallSimplemap())})
    for (std::size_t i = 0; i < bytes.size(); ++i)
      for (const int change : {0x01, 0x80, 0xff}) {
        std::string changed = bytes;
        changed[i] = char(changed[i] ^ change);
        const std::string file = write(changed);
        if (errorOf(file, coarse).empty()) continue;
        expectError(file, {}, coarse);
        ++refused;
      }
  EXPECT_GT(refused, 300);
}

TEST_F(BadInput, otherMrptObjectIsNamed) {
  expectRefused(test::streamed(mrpt::obs::CObservationOdometry()), "CObservationOdometry");
}

TEST_F(BadInput, laterVersionsAreNamed) {
  std::string bytes = test::streamed(test::smallGrid());
  bytes[1 + (bytes[0] & 0x7f)] = 8;
  expectRefused(bytes, "version 8 of COccupancyGridMap2D, and only 0 to 7 are known");
}

class BadGridmap : public BadInput {
 protected:
  /** A gridmap that claims this, with `cells` behind it. */
  std::string claiming(std::uint32_t width, std::uint32_t height, float xMax, float yMax,
                       float resolution, const std::string& cells = {}) const {
    return "\x93"
           "COccupancyGridMap2D\x06\x08" +
           raw(width) + raw(height) + raw(0.f) + raw(xMax) + raw(0.f) + raw(yMax) +
           raw(resolution) + cells;
  }
};

TEST_F(BadGridmap, absurdSizesAreRefused) {
  expectRefused(claiming(65536, 65536, 65536, 65536, 1), "65536 x 65536 cells");
  expectRefused(claiming(60000, 60000, 3000, 3000, 0.05f), "60000 x 60000 cells");
  expectRefused(claiming(0, 0, 0, 0, 1), "no cells");
  expectRefused(claiming(0, 5, 0, 5, 1), "no cells");
  expectRefused(claiming(19999, 19999, 19999, 19999, 1), "fewer cells");
  expectRefused(test::gzipped(claiming(19999, 19999, 19999, 19999, 1)), "fewer cells");
}

TEST_F(BadGridmap, numbersThatAreNoneAreRefused) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  const std::string cells(4, '\0');
  for (const float bad : {inf, -inf, float(NAN), 1e30f}) {
    expectRefused(claiming(2, 2, bad, 2, 1, cells), "contradicts its bounds");
    expectRefused(claiming(2, 2, 2, bad, 1, cells), "contradicts its bounds");
    expectRefused(claiming(2, 2, 2, 2, bad, cells), "resolution");
  }
  for (const float bad : {0.f, -1.f, 1e-30f})
    expectRefused(claiming(2, 2, 2, 2, bad, cells), "resolution");
}

TEST_F(BadGridmap, sizeThatContradictsTheBoundsIsRefused) {
  expectRefused(claiming(2, 2, 9, 2, 1, std::string(4, '\0')), "contradicts its bounds");
}

TEST_F(BadGridmap, hugeOptionListIsRefused) {
  std::string bytes = test::streamed(test::smallGrid());
  // The list of weights stands before the cache flag and the closing parts; all its bytes at once.
  const auto params = bytes.rfind("TMapGenericParams");
  ASSERT_NE(params, std::string::npos);
  const std::size_t weights = bytes.size();
  for (std::size_t i = params; i-- > 4;)
    if (bytes.substr(i, 4) == raw<std::uint32_t>(100)) {
      bytes.replace(i, 4, raw<std::uint32_t>(0xffffffff));
      expectRefused(bytes, "cut short or damaged");
      return;
    }
  FAIL() << "no list of 100 weights in " << weights << " bytes";
}

TEST_F(BadInput, pgmWithAnEndlessCommentSaysSo) {
  const std::string head = "P5\n#", rest = "\n2 2\n255\n" + std::string(4, '\xff');
  expectRefused(head + std::string(70'000, 'c') + rest, "a comment in it");
  expectRefused(head + "no end", "a comment in it");
  const GreyMap map = loadGrid(dir_.write("long", head + std::string(60'000, 'c') + rest), {});
  EXPECT_EQ(map.grey, std::vector<std::uint8_t>(4, 255));
}

class BadSimplemap : public BadInput {
 protected:
  const std::string pose_ = test::streamed(mrpt::poses::CPose3DPDFGaussian());
  std::string claiming(std::uint32_t entries, const std::string& rest = {}) const {
    return "\x8a"
           "CSimpleMap\x01" +
           raw(entries) + rest;
  }
  std::string frameClaiming(std::uint32_t observations, const std::string& rest = {}) const {
    return claiming(1, pose_ +
                           "\x8d"
                           "CSensoryFrame\x02" +
                           raw(observations) + rest);
  }
};

TEST_F(BadSimplemap, claimedEntriesNeedBytes) {
  expectRefused(claiming(200'000'000), "200000000 entries");
  expectRefused(claiming(0xffffffff, pose_), "4294967295 entries");
  expectRefused(test::gzipped(claiming(200'000'000, std::string(1000, '\0'))), "entries");
}

TEST_F(BadSimplemap, claimedObservationsAndBeamsNeedBytes) {
  expectRefused(frameClaiming(200'000'000), "observations");
  const std::string scan =
      "\x97"
      "CObservation2DRangeScan\x07" +
      raw(3.f) + "\x01" + raw(80.f) + test::streamed(mrpt::poses::CPose3D());
  for (const std::uint32_t beams : {90'000u, 0xffffffffu})
    expectRefused(frameClaiming(1, scan + raw(beams) + std::string(64, '\0')));
}

TEST_F(BadSimplemap, claimedParticlesNeedBytes) {
  expectRefused(claiming(1,
                         "\x93"
                         "CPose3DPDFParticles\x01" +
                             raw<std::uint32_t>(0xffffffff) + std::string(64, '\0')),
                "particles");
}

TEST_F(BadSimplemap, absentPoseIsRefused) {
  expectRefused(claiming(1,
                         "\x87"
                         "nullptr\x88" +
                             std::string(64, '\0')));
}

TEST_F(BadSimplemap, mapWithoutScansSaysSo) {
  expectRefused(test::streamed(mrpt::maps::CSimpleMap()), "no horizontal 2D range scan");
  expectRefused(frameClaiming(0, "\x88\x88"), "no horizontal 2D range scan");
}

TEST_F(BadSimplemap, absurdPosesAreRefused) {
  for (const double x : {1e6, 1e300, double(NAN), double(INFINITY)}) {
    auto simplemap = test::smallSimplemap();
    dynamic_cast<mrpt::poses::CPose3DPDFGaussian&>(*test::entryOf(simplemap, 1).pose).mean.x(x);
    expectRefused(test::streamed(simplemap));
  }
}

TEST_F(BadSimplemap, scansThatReachTooFarApartAreRefused) {
  auto simplemap = test::smallSimplemap();
  auto& pose = *test::entryOf(simplemap, 1).pose;
  dynamic_cast<mrpt::poses::CPose3DPDFGaussian&>(pose).mean = mrpt::poses::CPose3D(9e4, 9e4, 0);
  expectRefused(test::streamed(simplemap), "400 million");
}

class BadPicture : public BadInput {};

TEST_F(BadPicture, absurdSizesAreRefused) {
  expectRefused("P5 60000 60000 255\n", "60000 x 60000 pixels");
  expectRefused("P2 99999999999999999999 1 255\n");
  expectRefused("P5 0 5 255\n", "no pixels");
  expectRefused("P5 19999 19999 255\n", "pixels are missing");
  expectRefused("P5 5 5 0\n1234512345123451234512345", "brightest");
}

/** The first chunk's size and checksum rewritten. */
std::string pngClaiming(std::uint32_t size) {
  std::string bytes = test::png(1, 1, 1, "x");
  for (int i = 0; i < 4; ++i) bytes[16 + i] = bytes[20 + i] = char(size >> (24 - 8 * i));
  const auto crc = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(&bytes[12]), 17));
  for (int i = 0; i < 4; ++i) bytes[29 + i] = char(crc >> (24 - 8 * i));
  return bytes;
}

TEST_F(BadPicture, pngThatClaimsMoreThanItHoldsIsRefused) {
  expectRefused(pngClaiming(60000), "60000 x 60000 pixels");
  expectRefused(pngClaiming(0xffffffff), "pixels");
  expectRefused(pngClaiming(19999), "fewer pixels");
  expectRefused(pngClaiming(30), "damaged");
  expectRefused(pngClaiming(0), "no pixels");
}

class BadYaml : public BadInput {
 protected:
  void expectYamlRefused(const std::string& text, const std::string& part) const {
    expectError(dir_.write("map.yaml", text), part);
  }
  void SetUp() override { dir_.write("map.pgm", "P2 1 1 255 7\n"); }
};

TEST_F(BadYaml, missingPictureIsNamed) {
  expectYamlRefused("image: none.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n", "none.pgm");
}

TEST_F(BadYaml, damagedPictureIsNamed) {
  const std::string picture = dir_.write("bad.pgm", "junk");
  const std::string text =
      errorOf(dir_.write("map.yaml", "image: bad.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"));
  EXPECT_EQ(text.compare(0, picture.size() + 2, picture + ": "), 0) << text;
}

TEST_F(BadYaml, everyValueIsChecked) {
  const std::string image = "image: map.pgm\n", resolution = "resolution: 0.05\n",
                    origin = "origin: [0, 0, 0]\n", good = image + resolution + origin;
  ASSERT_EQ(errorOf(dir_.write("map.yaml", good)), "");
  expectYamlRefused(image + origin, "no 'resolution'");
  for (const std::string bad : {"0", "-1", ".inf", ".nan", "1e9", "wide", "[1]"})
    expectYamlRefused(image + origin + "resolution: " + bad, "'resolution'");
  expectYamlRefused(image + resolution, "'origin'");
  for (const std::string bad : {"5", "[1]", "[1, 2, 3, 4]", "[.nan, 0, 0]", "[0, x, 0]"})
    expectYamlRefused(image + resolution + "origin: " + bad, "'origin'");
  expectYamlRefused(image + resolution + "origin: [0, 0, 50]", "'origin'");
  expectYamlRefused(good + "occupied_thresh: 65", "'occupied_thresh'");
  expectYamlRefused(good + "free_thresh: 0.9\noccupied_thresh: 0.2", "'free_thresh'");
  expectYamlRefused(good + "negate: perhaps", "'negate'");
  expectYamlRefused(good + "mode: quaternary", "'mode'");
  expectYamlRefused("image:\n" + resolution + origin, "'image'");
  expectYamlRefused(good + "a: [b", "not valid yaml");
}

}  // namespace
}  // namespace roomgraph
