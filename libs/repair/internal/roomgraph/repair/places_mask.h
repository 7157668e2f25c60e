#pragma once
#include <string>

#include "roomgraph/repair/MarkedFile.h"

namespace roomgraph {

// nav2_map_server
// In:   the yaml of a mask for nav2's costmap filters
// Out:  MarkedFile
// Next: carryThings

/** The marked regions of a keepout or speed mask: connected cells that are neither free nor
 *  unknown. Carried, each cell is bent as the maps are, and none gets lost: where two meet, what is
 *  marked more stays. Mode, thresholds, resolution and all other keys are kept; the picture is as
 *  large as the new map, or larger where something lies beside it. The key `regions` of the yaml,
 *  which nav2 skips, tells of each where it lies, how large it is, its state, error_m and reason.
 *  Pictures other than pgm are written as png.
 *  @throws DataError in the name of `file` where it is none, or its picture cannot be read. */
MarkedFile maskPlaces(const std::string& text, const std::string& file);

/** Whether a text may be one. */
bool looksLikeMask(const std::string& text);

}  // namespace roomgraph
