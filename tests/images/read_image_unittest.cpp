#include <gtest/gtest.h>

#include "TestFolder.h"
#include "map_files.h"
#include "refusal.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

using test::raw;
using Greys = std::vector<std::uint8_t>;

Greys greysOf(const std::string& bytes) {
  static const TestFolder dir;  // many files: making a directory for each takes long
  return loadGrid(dir.write("a", bytes), {}).grey;
}

std::string errorOf(const std::string& bytes) {
  return test::refusalOf([&] { greysOf(bytes); });
}

/** What stands before the pixels, with an info header of 40 bytes and more behind it. */
std::string bmpStart(int width, int height, int bits, int compression, const std::string& more,
                     std::size_t pixelBytes) {
  const std::size_t start = 14 + 40 + more.size();
  return "BM" + raw(std::uint32_t(start + pixelBytes)) + raw<std::uint32_t>(0) +
         raw(std::uint32_t(start)) + raw<std::uint32_t>(40) + raw<std::int32_t>(width) +
         raw<std::int32_t>(height) + raw<std::uint16_t>(1) + raw(std::uint16_t(bits)) +
         raw(std::uint32_t(compression)) + std::string(20, '\0') + more;
}

std::string bmp(int width, int height, int bits, const std::string& pixels, int compression = 0,
                const std::string& more = {}) {
  return bmpStart(width, height, bits, compression, more, pixels.size()) + pixels;
}

/** A palette of greys: colour i has level i * step. */
std::string greyPalette(int colours, int step) {
  std::string palette;
  for (int i = 0; i < colours; ++i) palette += std::string(3, char(i * step)) + '\0';
  return palette;
}

TEST(ReadImage, bmpsOfEveryDepthStandOnTheirLowestRow) {
  // Rows from the lowest, each padded to 4 bytes.
  EXPECT_EQ(greysOf(bmp(2, 2, 24, {1, 2, 3, 10, 20, 30, 0, 0, 4, 4, 4, 5, 5, 5, 0, 0})),
            (Greys{2, 20, 4, 5}));
  EXPECT_EQ(greysOf(bmp(2, 2, 8, {7, 9, 0, 0, 1, 0, 0, 0}, 0, greyPalette(256, 1))),
            (Greys{7, 9, 1, 0}));
  EXPECT_EQ(greysOf(bmp(3, 1, 4, {0x1f, 0x20, 0, 0}, 0, greyPalette(16, 17))),
            (Greys{17, 255, 34}));
  EXPECT_EQ(greysOf(bmp(3, 1, 1, {char(0xa0), 0, 0, 0}, 0, greyPalette(2, 255))),
            (Greys{255, 0, 255}));
  EXPECT_EQ(greysOf(bmp(1, 1, 32, {3, 6, 9, 0})), (Greys{6})) << "the fourth byte is no alpha";
  EXPECT_EQ(greysOf(bmp(2, 1, 16, raw<std::uint16_t>(0x7fff) + raw<std::uint16_t>(0))),
            (Greys{255, 0}));
}

TEST(ReadImage, bmpsMayBeginWithTheirTopRow) {
  EXPECT_EQ(greysOf(bmp(1, -2, 24, {1, 1, 1, 0, 2, 2, 2, 0})), (Greys{2, 1}));
}

TEST(ReadImage, bmpsWithMasksMayHoldAlpha) {
  const std::string masks =
      raw(0xff000000u) + raw(0x00ff0000u) + raw(0x0000ff00u) + raw(0x000000ffu);
  const std::string pixels = raw(0x0a0a0affu) + raw(0x0a0a0a00u);
  EXPECT_EQ(greysOf(bmp(2, 1, 32, pixels, 6, masks)), (Greys{10, 128}));
}

TEST(ReadImage, theOldestBmpsAreRead) {
  const std::string start = "BM" + raw<std::uint32_t>(30) + raw<std::uint32_t>(0) +
                            raw<std::uint32_t>(26) + raw<std::uint32_t>(12);
  EXPECT_EQ(greysOf(start + raw<std::uint16_t>(1) + raw<std::uint16_t>(1) + raw<std::uint16_t>(1) +
                    raw<std::uint16_t>(24) + "\x05\x05\x05" + '\0'),
            (Greys{5}));
}

TEST(ReadImage, badBmpsAreRefused) {
  const std::string good = bmp(2, 2, 8, {7, 9, 0, 0, 1, 0, 0, 0}, 0, greyPalette(256, 1));
  for (std::size_t size = 18; size < good.size(); ++size)
    EXPECT_NE(errorOf(good.substr(0, size)), "") << size;
  EXPECT_NE(errorOf(good + "x").find("something follows"), std::string::npos);
  EXPECT_NE(errorOf(bmp(2, 2, 8, "12345678", 1, greyPalette(256, 1))).find("compressed"),
            std::string::npos);
  EXPECT_NE(errorOf(bmp(60000, 60000, 8, "", 0, greyPalette(256, 1))).find("pixels, more than"),
            std::string::npos);
  EXPECT_NE(errorOf(bmp(19999, -19999, 24, "")).find("pixels are missing"), std::string::npos);
  EXPECT_NE(errorOf(bmp(-2, 2, 24, "12345678")).find("width is negative"), std::string::npos);
  EXPECT_NE(errorOf(bmp(2, INT32_MIN, 24, "12345678")), "");
  EXPECT_NE(errorOf(bmp(1, 1, 7, "1234")).find("kind of pixel"), std::string::npos);
  EXPECT_NE(errorOf(bmp(0, 1, 24, "")).find("no pixels"), std::string::npos);
}

TEST(ReadImage, pixelsBeyondTheirPaletteAreRefused) {
  std::string bytes = bmp(1, 1, 8, {9, 0, 0, 0}, 0, greyPalette(4, 1));
  bytes.replace(46, 4, raw<std::uint32_t>(4));  // colours in the palette
  EXPECT_NE(errorOf(bytes).find("palette"), std::string::npos);
  bytes.replace(46, 4, raw<std::uint32_t>(4'000'000));
  EXPECT_NE(errorOf(bytes).find("palette"), std::string::npos);
}

/** Left half at one level, right half at another. */
std::string halves(int width, int height, char left, char right, int channels) {
  std::string pixels;
  for (int i = 0; i < width * height; ++i)
    pixels += std::string(std::size_t(channels), i % width < width / 2 ? left : right);
  return pixels;
}

TEST(ReadImage, jpegsAreReadInGreyAndInColour) {
  for (const int channels : {1, 3}) {
    const std::string pixels = halves(32, 16, 10, char(240), channels);
    const Greys greys = greysOf(test::jpeg(32, 16, channels, pixels));
    ASSERT_EQ(greys.size(), 32u * 16u);
    EXPECT_NEAR(greys[0], 10, 3);
    EXPECT_NEAR(greys[31], 240, 3);
  }
}

TEST(ReadImage, jpegsStandOnTheirLowestRow) {
  const std::string pixels = std::string(8 * 8, char(200)) + std::string(8 * 8, char(50));
  const Greys greys = greysOf(test::jpeg(8, 16, 1, pixels));
  EXPECT_NEAR(greys.front(), 50, 3);
  EXPECT_NEAR(greys.back(), 200, 3);
}

TEST(ReadImage, badJpegsAreRefused) {
  const std::string good = test::jpeg(32, 16, 3, halves(32, 16, 10, char(240), 3));
  ASSERT_EQ(errorOf(good), "");
  for (std::size_t size = 3; size < good.size(); ++size)
    EXPECT_NE(errorOf(good.substr(0, size)), "") << size;
  EXPECT_NE(errorOf(good + "x").find("something follows"), std::string::npos);
}

TEST(ReadImage, jpegsThatClaimMoreThanTheyHoldAreRefused) {
  std::string bytes = test::jpeg(8, 8, 1, std::string(64, 'x'));
  const std::size_t frame = bytes.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t i = frame + 5; i < frame + 9; ++i) bytes[i] = char(0x4e);  // 20046 x 20046
  EXPECT_NE(errorOf(bytes).find("pixels"), std::string::npos);
  bytes[frame + 5] = bytes[frame + 7] = char(0xff);
  EXPECT_NE(errorOf(bytes).find("pixels"), std::string::npos);
}

TEST(ReadImage, aBarePictureWithoutScaleIsNoted) {
  const TestFolder dir;
  const std::string file = dir.write("a.png", test::png(1, 1, 1, "x"));
  const GreyMap assumed = loadGrid(file, {});
  ASSERT_EQ(assumed.notes.size(), 1u);
  EXPECT_EQ(assumed.notes[0].code, "assumed_resolution");
  EXPECT_NE(assumed.notes[0].text.find("0.05 m"), std::string::npos);
  LoadGridOptions given;
  given.isResolutionGiven = true;
  EXPECT_TRUE(loadGrid(file, given).notes.empty());
}

}  // namespace
}  // namespace roomgraph
