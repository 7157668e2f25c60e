#pragma once
#include <string>

#include "roomgraph/grid/LabelMap.h"

namespace roomgraph {

// In:   the name of a label picture
// Out:  LabelMap
// Next: scoreRooms

/** Reads a picture of labelled regions, recognised by its content; it may be gzipped.
 *  - Grey (png of 1 to 16 bits, pgm): the grey level as it is stored is the label, and 0 is none.
 *    White is a label like any other, as a map of 255 regions needs it.
 *  - Colour (png with a palette or with 8 bits per channel): every distinct colour is a label, the
 *    number 65536 R + 256 G + B. Black and white are none: such pictures draw walls in the one and
 *    leave the outside in the other. Any other background is taken for a region.
 *  Pixels that are fully transparent are none. No gamma, no colour profile, no smoothing: a picture
 *  that was scaled with interpolation has false labels along its borders.
 *
 *  The file is checked as for loadGrid(): sizes and checksums first, at most 400 million pixels,
 *  and nothing is allocated on the word of a header alone. O(file + pixels). Prints nothing.
 *  @throws DataError with one line (file, problem, remedy) where the file is missing, damaged, no
 *  png or pgm, or has colours of 16 bits per channel, of which two could fall on one label. */
[[nodiscard]] LabelMap readLabels(const std::string& file);

}  // namespace roomgraph
