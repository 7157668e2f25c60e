#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "roomgraph/base/checked_file.h"

namespace roomgraph {

struct PgmHeader {
  bool isText = false;
  std::uint64_t width = 0, height = 0, brightest = 0;
  std::size_t size = 0;  ///< bytes before the first pixel
};

/** Reads the size from the first bytes of a pgm (P2, P5). Throws DataError where it is damaged. */
PgmHeader readPgmHeader(ByteReader in);
/** Throws DataError where the file is damaged, too short for its pixels, or goes on behind them, as
 *  far as that can be told without reading them. The size must be a sane one. */
void checkPgm(CheckedFile& file, const PgmHeader& header);
/** Hands out the pixels of a checked pgm as they are stored, row by row from the top; `row` counts
 *  from the lowest. Values may be above `brightest`. Throws DataError where pixels are missing or
 *  something follows them. */
void decodePgm(CheckedFile& file, const PgmHeader& header,
               const std::function<void(std::size_t row, const std::vector<std::uint32_t>&)>& take);

}  // namespace roomgraph
