#include <csetjmp>

#include "decoders.h"
// jpeglib.h uses what stands above it.
#include <jpeglib.h>

#include "pixels.h"
#include "roomgraph/base/checked_file.h"

namespace roomgraph {
namespace {

// A block of 64 pixels takes a bit at least, and may stand for four with coarser colours.
constexpr std::uint64_t kMostPixelsPerByte = 2048;

/** libjpeg's state and the way back from its errors. */
struct JpegDecoder {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf onError;
  std::vector<std::uint8_t> row, grey;

  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg); }
};

[[noreturn]] void giveUp(j_common_ptr jpeg) {
  std::longjmp(static_cast<JpegDecoder*>(jpeg->client_data)->onError, 1);
}

/** Warnings have negative levels: libjpeg fills in what is missing with grey. */
void onMessage(j_common_ptr jpeg, int level) {
  if (level < 0) giveUp(jpeg);
}

/** Holds nothing that a jump could leak. */
bool readHeader(JpegDecoder& d, ByteView bytes) {
  d.jpeg.err = jpeg_std_error(&d.errors);
  d.errors.error_exit = giveUp;
  d.errors.emit_message = onMessage;
  d.jpeg.client_data = &d;
  if (setjmp(d.onError)) return false;
  jpeg_create_decompress(&d.jpeg);
  jpeg_mem_src(&d.jpeg, bytes.data, static_cast<unsigned long>(bytes.size));
  return jpeg_read_header(&d.jpeg, TRUE) == JPEG_HEADER_OK;
}

void readRow(JpegDecoder& d) {
  JSAMPROW row = d.row.data();
  jpeg_read_scanlines(&d.jpeg, &row, 1);
  const auto channels = std::size_t(d.jpeg.output_components);
  for (std::size_t i = 0; i < d.row.size(); i += channels) {
    const std::uint8_t* p = row + i;
    d.grey.push_back(channels == 1 ? p[0] : averaged(p[0], p[1], p[2]));
  }
}

bool readRows(JpegDecoder& d) {
  if (setjmp(d.onError)) return false;
  d.jpeg.out_color_space = d.jpeg.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_start_decompress(&d.jpeg);
  while (d.jpeg.output_scanline < d.jpeg.output_height) readRow(d);
  jpeg_finish_decompress(&d.jpeg);
  return true;
}

}  // namespace

bool isJpeg(ByteView head) {
  return head.size >= 3 && head.data[0] == 0xff && head.data[1] == 0xd8 && head.data[2] == 0xff;
}

std::vector<std::uint8_t> decodeJpeg(ByteView jpeg, const std::string& file, GridFrame& frame) {
  JpegDecoder d;
  if (!readHeader(d, jpeg))
    refuse(file, "it is damaged: it is not a whole jpeg", kSavePictureAgain);
  const J_COLOR_SPACE space = d.jpeg.jpeg_color_space;
  if (space != JCS_GRAYSCALE && space != JCS_YCbCr && space != JCS_RGB)
    refuse(file, "is a jpeg for printing, with other colours than red, green and blue",
           "save it as png");
  checkPictureSize(d.jpeg.image_width, d.jpeg.image_height, file);
  frame.width = int(d.jpeg.image_width), frame.height = int(d.jpeg.image_height);
  const std::uint64_t pixels = std::uint64_t(d.jpeg.image_width) * d.jpeg.image_height;
  if (pixels / kMostPixelsPerByte > jpeg.size)
    refuse(file, "it is damaged: it holds fewer pixels than it says", kSavePictureAgain);
  d.row.resize(std::size_t(d.jpeg.image_width) * (d.jpeg.num_components == 1 ? 1 : 3));
  d.grey.reserve(pixels);  // no page of it is written before its row is read
  if (!readRows(d)) refuse(file, "it is damaged: its pixels cannot be read", kSavePictureAgain);
  if (d.jpeg.src->bytes_in_buffer > 0)
    refuse(file, "something follows the picture in it", "remove what was appended");
  return std::move(d.grey);
}

}  // namespace roomgraph
