#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"

namespace roomgraph {

bool isPng(ByteView head);
bool isPgm(ByteView head);
/** Whether readImage() knows the kind of picture. */
bool isImage(ByteView head);
/** Throws DataError for a picture without pixels, or with more than kMostCells. */
void checkPictureSize(std::uint64_t width, std::uint64_t height, const std::string& file);

/** Reads a png, pgm, bmp or jpeg into the map's size and grey levels, row 0 lowest. Colours are
 *  averaged, transparent pixels show a background of 128. Throws DataError where it is damaged
 *  (checksums, missing pixels), followed by something else, or larger than kMostCells. */
void readImage(CheckedFile& file, GreyMap& map);

/** 1 for each pixel that is not opaque, else 0, in the order of readImage(), which must have read
 *  the file; empty where the kind of picture, or this one, knows no transparency. */
std::vector<std::uint8_t> readClearPixels(CheckedFile& file);

}  // namespace roomgraph
