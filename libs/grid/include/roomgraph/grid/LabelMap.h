#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace roomgraph {

/** A picture of regions: which one each pixel belongs to. */
struct LabelMap {
  int width = 0, height = 0;  ///< pixels
  /** Row-major, row 0 lowest, as the cells of a Grid; 0 is none. The numbers mean nothing but that
   *  equal ones are one region. */
  std::vector<std::uint32_t> label;
  /** Where it came from; empty where it was made. */
  struct Source {
    std::string file;    ///< as the caller named it
    std::string sha256;  ///< of the file's bytes, lower-case hex
  } source;

  [[nodiscard]] std::size_t pixelCount() const { return std::size_t(width) * std::size_t(height); }
};

}  // namespace roomgraph
