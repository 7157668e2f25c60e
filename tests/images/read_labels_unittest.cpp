#include "roomgraph/images/read_labels.h"

#include <gtest/gtest.h>
#include <png.h>

#include <stdexcept>

#include "TestFolder.h"
#include "map_files.h"
#include "refusal.h"

namespace roomgraph {
namespace {

using Labels = std::vector<std::uint32_t>;

/** What libpng's simplified writer cannot write. */
struct RawPng {
  int width = 0, height = 0, bits = 8, colourType = PNG_COLOR_TYPE_GRAY;
  std::string rows = {};  ///< as they are stored, from the top
  std::vector<png_color> palette = {};
  std::vector<png_byte> paletteAlpha = {};
  int transparentGrey = -1;
  bool isInterlaced = false;
};

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

std::string written(RawPng raw) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  if (setjmp(png_jmpbuf(png))) throw std::runtime_error("libpng");
  png_set_write_fn(png, &out, append, nullptr);
  png_set_IHDR(png, info, png_uint_32(raw.width), png_uint_32(raw.height), raw.bits, raw.colourType,
               raw.isInterlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!raw.palette.empty()) png_set_PLTE(png, info, raw.palette.data(), int(raw.palette.size()));
  if (!raw.paletteAlpha.empty())
    png_set_tRNS(png, info, raw.paletteAlpha.data(), int(raw.paletteAlpha.size()), nullptr);
  png_color_16 grey{};
  grey.gray = png_uint_16(raw.transparentGrey);
  if (raw.transparentGrey >= 0) png_set_tRNS(png, info, nullptr, 0, &grey);
  const std::size_t rowBytes = raw.rows.size() / std::size_t(raw.height);
  std::vector<png_bytep> rows;
  for (std::size_t y = 0; y < std::size_t(raw.height); ++y)
    rows.push_back(reinterpret_cast<png_bytep>(&raw.rows[y * rowBytes]));
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

std::string labelsError(const std::string& file) {
  return test::refusalOf([&] { readLabels(file); });
}

class ReadLabels : public testing::Test {
 protected:
  Labels labels(const std::string& bytes) const {
    return readLabels(dir_.write("labels", bytes)).label;
  }
  /** One line "FILE: problem: remedy" with `part` in it. */
  void expectRefused(const std::string& bytes, const std::string& part) const {
    const std::string file = dir_.write("labels", bytes), text = labelsError(file);
    EXPECT_EQ(text.compare(0, file.size() + 2, file + ": "), 0) << text;
    EXPECT_NE(text.find(": ", file.size() + 2), std::string::npos) << text;
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
  TestFolder dir_;
};

TEST_F(ReadLabels, greyLevelsAreLabelsAndTheLowestRowComesFirst) {
  const std::string file = dir_.write("a.png", test::png(3, 2, 1, {0, 1, 2, 3, 4, char(255)}));
  const LabelMap map = readLabels(file);
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_EQ(map.label, (Labels{3, 4, 255, 0, 1, 2}));
  EXPECT_EQ(map.source.file, file);
  EXPECT_EQ(map.source.sha256.size(), 64u);
}

TEST_F(ReadLabels, sixteenBitsAreKept) {
  RawPng png{3, 2, 16};
  png.rows = std::string("\x00\x00\x01\x00\x01\x01\xff\xff\x00\x07\xea\x60", 12);
  EXPECT_EQ(labels(written(png)), (Labels{65535, 7, 60000, 0, 256, 257}));
  png.isInterlaced = true;
  EXPECT_EQ(labels(written(png)), (Labels{65535, 7, 60000, 0, 256, 257}));
}

TEST_F(ReadLabels, fewBitsAreNotScaled) {
  EXPECT_EQ(labels(written({4, 1, 4, PNG_COLOR_TYPE_GRAY, "\x12\xf3"})), (Labels{1, 2, 15, 3}));
  EXPECT_EQ(labels(written({4, 1, 2, PNG_COLOR_TYPE_GRAY, "\x6c"})), (Labels{1, 2, 3, 0}));
  EXPECT_EQ(labels(written({8, 1, 1, PNG_COLOR_TYPE_GRAY, "\xa1"})),
            (Labels{1, 0, 1, 0, 0, 0, 0, 1}));
}

TEST_F(ReadLabels, distinctColoursAreLabelsExceptBlackAndWhite) {
  const std::string pixels("\x00\x00\x00\xff\xff\xff\x01\x02\x03\x80\x80\x80", 12);
  EXPECT_EQ(labels(test::png(4, 1, 3, pixels)), (Labels{0, 0, 0x010203, 0x808080}));
}

/** Two colours may have one mean, which is all that a map keeps of them. */
TEST_F(ReadLabels, coloursOfTheSameBrightnessDiffer) {
  const Labels found = labels(test::png(2, 1, 3, "abccba"));
  EXPECT_NE(found[0], found[1]);
}

TEST_F(ReadLabels, palettesCountByTheirColours) {
  RawPng png{4, 2, 2, PNG_COLOR_TYPE_PALETTE, std::string("\x1b\xff", 2)};
  png.palette = {{0, 0, 0}, {255, 255, 255}, {255, 0, 0}, {0, 0, 255}};
  EXPECT_EQ(labels(written(png)), (Labels{255, 255, 255, 255, 0, 0, 0xff0000, 255}));
  png.paletteAlpha = {255, 255, 0};
  EXPECT_EQ(labels(written(png)), (Labels{255, 255, 255, 255, 0, 0, 0, 255}));
}

TEST_F(ReadLabels, onlyFullyTransparentPixelsAreNone) {
  const std::string pixels("\x01\x02\x03\x00\x01\x02\x03\x01\x01\x02\x03\xff", 12);
  EXPECT_EQ(labels(test::png(3, 1, 4, pixels)), (Labels{0, 0x010203, 0x010203}));
  EXPECT_EQ(labels(written({2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {9, 0, 9, 1}})), (Labels{0, 9}));
  const std::string wide("\x01\x02\x00\x00\x01\x02\x00\x01", 8);
  EXPECT_EQ(labels(written({2, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA, wide})), (Labels{0, 0x0102}));
  RawPng keyed{2, 1, 4, PNG_COLOR_TYPE_GRAY, "\x56"};
  keyed.transparentGrey = 5;
  EXPECT_EQ(labels(written(keyed)), (Labels{0, 6}));
}

TEST_F(ReadLabels, pgmValuesAreNotScaled) {
  EXPECT_EQ(labels("P2 3 2 7\n0 1 2\n3 7 5"), (Labels{3, 7, 5, 0, 1, 2}));
  EXPECT_EQ(labels("P5 2 1 255\n\x07\x08"), (Labels{7, 8}));
  EXPECT_EQ(labels(std::string("P5 2 1 65535\n\x01\x02\xff\xff", 17)), (Labels{0x0102, 65535}));
  EXPECT_EQ(labels(test::gzipped("P2 1 1 7\n3\n")), (Labels{3}));
}

TEST_F(ReadLabels, badFilesAreRefusedInOneLine) {
  EXPECT_NE(labelsError(dir_ / "none.png").find("there is no such file"), std::string::npos);
  expectRefused("", "is empty");
  expectRefused("Dear map", "is not a label picture");
  expectRefused("P5 60000 60000 255\n", "60000 x 60000 pixels");
  expectRefused("P5 0 5 255\n", "no pixels");
  expectRefused("P5 20 20 255\nabc", "pixels are missing");
  expectRefused("P2 2 1 7\n3 8\n", "above its brightest value");
  expectRefused("P2 2 1 7\n3 4\n5\n", "something follows");
  expectRefused(test::png(1, 1, 1, "x") + "x", "something follows");
  std::string broken = test::png(1, 1, 1, "x");
  broken[broken.size() - 13] ^= 1;
  expectRefused(broken, "checksum");
}

TEST_F(ReadLabels, picturesCutAnywhereAreRefused) {
  RawPng png{9, 7, 16};
  for (int i = 0; i < 9 * 7 * 2; ++i) png.rows += char(i * 37);
  const std::string bytes = written(png);
  ASSERT_EQ(labels(bytes).size(), 63u);
  for (std::size_t size = bytes.size() - 1; size > 0; --size)
    ASSERT_NE(labelsError(dir_.write("cut", bytes.substr(0, size))), "") << size << " bytes";
}

/** Their colours do not fit into a label, and two that are rounded to one would join two rooms. */
TEST_F(ReadLabels, coloursOfSixteenBitsAreRefused) {
  expectRefused(written({1, 1, 16, PNG_COLOR_TYPE_RGB, "abcdef"}), "16 bits per channel");
  expectRefused(written({1, 1, 16, PNG_COLOR_TYPE_RGB_ALPHA, "abcdefgh"}), "16 bits per channel");
}

}  // namespace
}  // namespace roomgraph
