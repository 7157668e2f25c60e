#include "read_bare_image.h"

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/images/read_image.h"

namespace roomgraph {

bool isBareImage(CheckedFile& file) { return isImage(file.head()); }

GreyMap readBareImage(CheckedFile& file, const LoadGridOptions& options) {
  GreyMap map;
  readImage(file, map);
  map.frame.resolution = options.resolution;
  // Common pictures of maps draw the unknown at 205 to 230, and free space near white.
  map.occupiedAbove = 0.65;
  map.freeBelow = 0.095;
  if (!options.isResolutionGiven)
    map.notes.push_back({"assumed_resolution",
                         formatted("a picture does not say how large it is: read at %g m per cell, "
                                   "the default of --resolution",
                                   options.resolution),
                         std::nullopt});
  return map;
}

}  // namespace roomgraph
