#pragma once
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/checked_file.h"

namespace roomgraph {

bool isPng(ByteView head);
bool isPgm(ByteView head);
/** Throws DataError for a picture without pixels, or with more than kMostCells. */
void checkPictureSize(std::uint64_t width, std::uint64_t height, const std::string& file);

/** Reads a png or pgm into the map's size and grey levels, row 0 lowest. Colours are averaged,
 *  transparent pixels show a background of 128. Throws DataError where it is damaged (checksums,
 *  missing pixels), followed by something else, or larger than kMostCells. */
void readImage(CheckedFile& file, GreyMap& map);

}  // namespace roomgraph
