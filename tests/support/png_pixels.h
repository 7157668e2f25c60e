#pragma once
#include <gtest/gtest.h>
#include <png.h>

#include <string>
#include <vector>

namespace roomgraph {

/** A decoded picture. */
struct Pixels {
  int width = 0, height = 0;
  std::vector<png_byte> rgb;

  int countOf(int red, int green, int blue) const {
    int count = 0;
    for (std::size_t i = 0; i < rgb.size(); i += 3)
      count += rgb[i] == red && rgb[i + 1] == green && rgb[i + 2] == blue;
    return count;
  }
};

inline Pixels decodePng(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Pixels pixels;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) {
    ADD_FAILURE() << "no PNG: " << image.message;
    return pixels;
  }
  image.format = PNG_FORMAT_RGB;
  pixels.width = int(image.width);
  pixels.height = int(image.height);
  pixels.rgb.resize(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, pixels.rgb.data(), 0, nullptr))
    ADD_FAILURE() << "damaged PNG: " << image.message;
  return pixels;
}

}  // namespace roomgraph
