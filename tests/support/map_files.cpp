#include "map_files.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>
#include <png.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
// jpeglib.h uses what stands above it.
#include <jpeglib.h>

namespace roomgraph::test {

namespace fs = std::filesystem;

std::string sharedFile(const std::string& name) {
  const std::string file = ROOMGRAPH_SHARED_DATA + name;
  return fs::exists(file) ? file : std::string();
}

bool isFile(const std::string& name) { return fs::is_regular_file(name); }

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 9, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib");
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string zstd(const std::string& bytes, bool isSealed) {
  const std::unique_ptr<ZSTD_CCtx, size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                   ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, isSealed);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_contentSizeFlag, isSealed);
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

std::string streamed(const mrpt::serialization::CSerializable& object) {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()),
          std::size_t(stream.getTotalBytesCount())};
}

std::string png(int width, int height, int channels, const std::string& pixels) {
  constexpr png_uint_32 formats[] = {PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB,
                                     PNG_FORMAT_RGBA};
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(width);
  image.height = png_uint_32(height);
  image.format = formats[channels - 1];
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr);
  std::string out(size, '\0');
  if (!png_image_write_to_memory(&image, out.data(), &size, 0, pixels.data(), 0, nullptr))
    throw std::runtime_error("libpng");
  out.resize(size);
  return out;
}

std::string jpeg(int width, int height, int channels, const std::string& pixels) {
  jpeg_compress_struct image{};
  jpeg_error_mgr errors{};
  image.err = jpeg_std_error(&errors);
  jpeg_create_compress(&image);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&image, &bytes, &size);
  image.image_width = JDIMENSION(width), image.image_height = JDIMENSION(height);
  image.input_components = channels;
  image.in_color_space = channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&image);
  jpeg_set_quality(&image, 98, TRUE);
  jpeg_start_compress(&image, TRUE);
  for (std::size_t y = 0; y < std::size_t(height); ++y) {
    const char* row = pixels.data() + y * std::size_t(width * channels);
    JSAMPROW rows[] = {reinterpret_cast<JSAMPROW>(const_cast<char*>(row))};
    jpeg_write_scanlines(&image, rows, 1);
  }
  jpeg_finish_compress(&image);
  jpeg_destroy_compress(&image);
  const std::string out(reinterpret_cast<const char*>(bytes), size);
  free(bytes);
  return out;
}

mrpt::maps::COccupancyGridMap2D smallGrid() {
  mrpt::maps::COccupancyGridMap2D grid(-0.2f, 0.3f, 0.3f, 0.7f, 0.1f);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) grid.setCell(x, y, 0.05f + 0.045f * float(5 * y + x));
  return grid;
}

mrpt::maps::CSimpleMap smallSimplemap() {
  mrpt::maps::CSimpleMap map;
  for (const double x : {-0.5, 0.0, 0.5}) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create();
    scan->aperture = float(M_PI);
    scan->maxRange = 10;
    scan->sensorLabel = "laser";
    scan->timestamp = mrpt::Clock::fromDouble(1.7e9 + x);
    scan->resizeScan(40);
    for (std::size_t i = 0; i < 40; ++i) {
      const double angle = -M_PI / 2 + M_PI * double(i) / 40;
      const double toSide = (2 - x) / std::max(1e-9, std::cos(angle));
      const double toEnd = 2 / std::max(1e-9, std::abs(std::sin(angle)));
      scan->setScanRange(i, float(std::min(toSide, toEnd)));
      scan->setScanRangeValidity(i, i != 7);
    }
    const auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scan);
    map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(x, 0, 0)), frame);
  }
  return map;
}

}  // namespace roomgraph::test
