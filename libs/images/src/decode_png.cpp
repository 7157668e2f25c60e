#include <png.h>
#include <zlib.h>

#include <csetjmp>
#include <memory>

#include "decoders.h"
#include "pixels.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/compressed.h"

namespace roomgraph {
namespace {

constexpr std::size_t kSignatureSize = 8;

std::uint32_t bigEndian(const std::uint8_t* p) {
  return std::uint32_t(p[0]) << 24 | std::uint32_t(p[1]) << 16 | std::uint32_t(p[2]) << 8 | p[3];
}

/** Everything that libpng's jumps must not skip the destructors of. */
struct PngDecoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ByteView left;
  // A plain array: a vector would write to all of it before the first pixel has proved its worth.
  std::unique_ptr<std::uint8_t[]> raw;
  std::vector<png_bytep> rows;

  ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

void readBytes(png_structp png, png_bytep out, std::size_t count) {
  auto& left = *static_cast<ByteView*>(png_get_io_ptr(png));
  if (count > left.size) png_error(png, "end of data");
  std::memcpy(out, left.data, count);
  left.data += count;
  left.size -= count;
}

[[noreturn]] void onError(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void onWarning(png_structp, png_const_charp) {}

std::uint8_t greyOf(const std::uint8_t* pixel, int channels) {
  const std::uint8_t level = channels >= 3 ? averaged(pixel[0], pixel[1], pixel[2]) : pixel[0];
  return channels % 2 == 1 ? level : overBackground(level, pixel[channels - 1]);
}

/** How the pixels of a row lie in memory. */
struct RowFormat {
  std::size_t width = 0;
  int channels = 0, bits = 0;
  int transparentGrey = -1;  ///< the grey that stands for no pixel, if there is one
};

void convertToGrey(const std::uint8_t* row, const RowFormat& format, std::uint8_t* out) {
  for (std::size_t x = 0; x < format.width; ++x)
    out[x] = greyOf(row + x * std::size_t(format.channels), format.channels);
}

void convertToClear(const std::uint8_t* row, const RowFormat& format, std::uint8_t* out) {
  const auto channels = std::size_t(format.channels);
  for (std::size_t x = 0; x < format.width; ++x)
    out[x] = channels % 2 == 0 && row[x * channels + channels - 1] < 255;
}

/** 8 bits for each of 1 to 4 channels. */
void prepareGrey(PngDecoder& d, RowFormat&) {
  png_set_expand(d.png);
  png_set_scale_16(d.png);
}

std::uint32_t labelOf(const std::uint8_t* pixel, const RowFormat& format) {
  constexpr std::uint32_t white = 0xffffff;
  const int bytes = format.bits / 8;
  const auto sample = [&](int channel) {
    const std::uint8_t* p = pixel + std::ptrdiff_t(channel) * bytes;
    return bytes == 2 ? std::uint32_t(p[0]) << 8 | p[1] : std::uint32_t(p[0]);
  };
  if (format.channels % 2 == 0 && sample(format.channels - 1) == 0) return 0;
  if (format.channels < 3) return int(sample(0)) == format.transparentGrey ? 0 : sample(0);
  const std::uint32_t colour = sample(0) << 16 | sample(1) << 8 | sample(2);
  return colour == white ? 0 : colour;
}

void convertToLabels(const std::uint8_t* row, const RowFormat& format, std::uint32_t* out) {
  const auto bytes = std::size_t(format.channels * format.bits / 8);
  for (std::size_t x = 0; x < format.width; ++x) out[x] = labelOf(row + x * bytes, format);
}

/** Greys as they are stored, in 8 or 16 bits; palettes as their colours. */
void prepareLabels(PngDecoder& d, RowFormat& format) {
  png_set_packing(d.png);
  if (png_get_color_type(d.png, d.info) & PNG_COLOR_MASK_COLOR) {
    png_set_expand(d.png);
    return;
  }
  png_color_16p grey = nullptr;
  if (png_get_tRNS(d.png, d.info, nullptr, nullptr, &grey) && grey)
    format.transparentGrey = grey->gray;
}

template <class Pixel>
struct Conversion {
  void (*prepare)(PngDecoder& d, RowFormat& format);
  void (*convertRow)(const std::uint8_t* row, const RowFormat& format, Pixel* out);
};

/** Appends the rows from the top. False where libpng gives up. Holds nothing that a jump could
 *  leak. */
template <class Pixel>
bool decode(PngDecoder& d, const Conversion<Pixel>& conversion, std::vector<Pixel>& pixels) {
  if (setjmp(png_jmpbuf(d.png))) return false;
  // Texts, profiles and the like may be packed, too, and are of no use here.
  constexpr int kAllButPixels = -1;
  png_set_keep_unknown_chunks(d.png, PNG_HANDLE_CHUNK_NEVER, nullptr, kAllButPixels);
  RowFormat format;
  png_read_info(d.png, d.info);
  conversion.prepare(d, format);
  const int passes = png_set_interlace_handling(d.png);
  png_read_update_info(d.png, d.info);
  const std::size_t height = png_get_image_height(d.png, d.info);
  const std::size_t rowBytes = png_get_rowbytes(d.png, d.info);
  format.width = png_get_image_width(d.png, d.info);
  format.channels = png_get_channels(d.png, d.info);
  format.bits = png_get_bit_depth(d.png, d.info);
  if (passes > 1) {  // rows come in pieces, so that all must be kept
    d.raw.reset(new std::uint8_t[rowBytes * height]);
    for (std::size_t y = 0; y < height; ++y) d.rows.push_back(d.raw.get() + y * rowBytes);
    png_read_image(d.png, d.rows.data());
  } else {
    d.raw.reset(new std::uint8_t[rowBytes]);
  }
  pixels.reserve(format.width * height);
  for (std::size_t y = 0; y < height; ++y) {
    if (passes == 1) png_read_row(d.png, d.raw.get(), nullptr);
    pixels.resize(pixels.size() + format.width);
    conversion.convertRow(passes == 1 ? d.raw.get() : d.rows[y], format, &pixels[y * format.width]);
  }
  return true;
}

template <class Pixel>
std::vector<Pixel> decodeAll(ByteView png, const Conversion<Pixel>& conversion,
                             const std::string& file) {
  std::vector<Pixel> pixels;
  PngDecoder decoder;
  decoder.left = png;
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  if (decoder.png) decoder.info = png_create_info_struct(decoder.png);
  if (!decoder.info) throw std::bad_alloc();
  png_set_read_fn(decoder.png, &decoder.left, readBytes);
  if (!decode(decoder, conversion, pixels))
    refuse(file, "it is damaged: its pixels cannot be read", kSavePictureAgain);
  return pixels;
}

}  // namespace

PngHeader readPngHeader(ByteReader reader) {
  reader.skip(kSignatureSize);
  const std::uint8_t* chunk = reader.take(8 + 13);
  if (bigEndian(chunk) != 13 || std::memcmp(chunk + 4, "IHDR", 4) != 0)
    refuse(reader.file(), "it is damaged: it does not begin with its size", kSavePictureAgain);
  PngHeader header;
  header.width = bigEndian(chunk + 8);
  header.height = bigEndian(chunk + 12);
  constexpr int channelsByType[] = {1, 0, 3, 1, 2, 0, 4};
  const int type = chunk[17];
  header.bitsPerChannel = chunk[16];
  header.bitsPerPixel = type <= 6 ? chunk[16] * channelsByType[type] : 0;
  header.isColour = type == 2 || type == 6;
  if (header.bitsPerPixel == 0)
    refuse(reader.file(), "it is damaged: its kind of pixel is unknown", kSavePictureAgain);
  return header;
}

void checkPng(ByteReader reader, const PngHeader& header) {
  reader.skip(kSignatureSize);
  std::uint64_t dataBytes = 0;
  for (bool isEnd = false; !isEnd;) {
    const std::uint32_t length = bigEndian(reader.take(4));
    const std::uint8_t* chunk = reader.take(std::uint64_t(length) + 4);
    const std::uint32_t stored = bigEndian(reader.take(4));
    if (crc32_z(0, chunk, std::size_t(length) + 4) != stored)
      refuse(reader.file(), "it is damaged: a checksum in it is wrong", kSavePictureAgain);
    if (std::memcmp(chunk, "IDAT", 4) == 0) dataBytes += length;
    isEnd = std::memcmp(chunk, "IEND", 4) == 0;
  }
  if (reader.left() > 0)
    refuse(reader.file(), "something follows the picture in it", "remove what was appended");
  const std::uint64_t pixelBytes =
      std::uint64_t(header.width) * header.height * std::uint64_t(header.bitsPerPixel) / 8;
  if (pixelBytes / kMostInflation > dataBytes)
    refuse(reader.file(), "it is damaged: it holds fewer pixels than it says", kSavePictureAgain);
}

std::vector<std::uint8_t> decodePng(ByteView png, const std::string& file) {
  return decodeAll(png, Conversion<std::uint8_t>{prepareGrey, convertToGrey}, file);
}

std::vector<std::uint8_t> decodePngClear(ByteView png, const std::string& file) {
  return decodeAll(png, Conversion<std::uint8_t>{prepareGrey, convertToClear}, file);
}

std::vector<std::uint32_t> decodePngLabels(ByteView png, const std::string& file) {
  return decodeAll(png, Conversion<std::uint32_t>{prepareLabels, convertToLabels}, file);
}

}  // namespace roomgraph
