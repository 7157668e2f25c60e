#include "roomgraph/images/png_bytes.h"

#include <png.h>
#include <zlib.h>

#include <new>

namespace roomgraph {
namespace {

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), size);
}

void noFlush(png_structp) {}

/** Memory is all that libpng can run out of here; its own way out is a jump over destructors. */
[[noreturn]] void throwOnError(png_structp, png_const_charp) { throw std::bad_alloc(); }

void noWarning(png_structp, png_const_charp) {}

/** One PNG being written to a string. */
class Encoder {
 public:
  Encoder(int width, int height, int depth, int type) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, throwOnError, noWarning);
    if (!png_) throw std::bad_alloc();
    info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_write_struct(&png_, nullptr);
      throw std::bad_alloc();
    }
    png_set_write_fn(png_, &bytes_, append, noFlush);
    png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), depth, type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png_, 2);
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    std::string key = "Software", author = kPngSoftware;
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key.data();
    text.text = author.data();
    png_set_text(png_, info_, &text, 1);
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() { png_destroy_write_struct(&png_, &info_); }

  png_structp png() { return png_; }
  png_infop info() { return info_; }
  std::string finish() {
    png_write_end(png_, nullptr);
    return std::move(bytes_);
  }

 private:
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string bytes_;
};

/** Maps count their rows from below, files of pictures from above. */
template <class Value, class Take>
void eachRowFromTop(const std::vector<Value>& values, int width, const Take& take) {
  for (std::size_t end = values.size(); end > 0; end -= std::size_t(width))
    take(&values[end - std::size_t(width)]);
}

/** All of a picture whose header is written. */
template <class Value>
std::string written(Encoder& encoder, const std::vector<Value>& values, int width) {
  eachRowFromTop(values, width, [&](const Value* row) {
    png_write_row(encoder.png(), reinterpret_cast<png_const_bytep>(row));
  });
  return encoder.finish();
}

}  // namespace

std::string pngBytes(const PaletteImage& image) {
  const int depth = image.palette.size() > 4 ? 4 : 2;
  Encoder encoder(image.width, image.height, depth, PNG_COLOR_TYPE_PALETTE);
  std::vector<png_color> palette;
  for (const Colour c : image.palette) palette.push_back({c.red, c.green, c.blue});
  png_set_PLTE(encoder.png(), encoder.info(), palette.data(), int(palette.size()));
  if (!image.alphas.empty()) {
    png_set_tRNS(encoder.png(), encoder.info(), image.alphas.data(), int(image.alphas.size()),
                 nullptr);
    png_set_compression_level(encoder.png(), 6);
  }
  png_write_info(encoder.png(), encoder.info());
  png_set_packing(encoder.png());
  return written(encoder, image.indices, image.width);
}

std::string pngBytes(const unsigned char* pixels, int width, int height, int stride) {
  Encoder encoder(width, height, 8, PNG_COLOR_TYPE_RGB);
  png_write_info(encoder.png(), encoder.info());
  // A pixel is a word, blue in its lowest byte, and the highest one is not used.
  png_set_filler(encoder.png(), 0, PNG_FILLER_AFTER);
  png_set_bgr(encoder.png());
  for (int y = 0; y < height; ++y)
    png_write_row(encoder.png(), pixels + std::ptrdiff_t(y) * stride);
  return encoder.finish();
}

std::string pngBytes(const std::vector<std::uint8_t>& levels, int width, int height) {
  Encoder encoder(width, height, 8, PNG_COLOR_TYPE_GRAY);
  png_write_info(encoder.png(), encoder.info());
  return written(encoder, levels, width);
}

std::string pngBytes(const std::vector<std::uint16_t>& levels, int width, int height) {
  Encoder encoder(width, height, 16, PNG_COLOR_TYPE_GRAY);
  // Most rows are like the one before.
  png_set_filter(encoder.png(), PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_write_info(encoder.png(), encoder.info());
  png_set_swap(encoder.png());
  return written(encoder, levels, width);
}

std::string pgmBytes(const std::vector<std::uint8_t>& levels, int width, int height) {
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  eachRowFromTop(levels, width, [&](const std::uint8_t* row) { bytes.append(row, row + width); });
  return bytes;
}

}  // namespace roomgraph
