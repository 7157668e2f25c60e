#pragma once
#include <string>

#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

// In:   Stages
// Out:  the bytes of a picture
// Next: writeFileAtomically

/** The picture of a result as the bytes of a PNG or SVG file: the known part of the map, rooms
 *  filled and numbered, corridors, ways inside of rooms, passages, clutter, vertices with a shape
 *  and a colour for each kind, legend, scale bar, and a title with the file's name and the counts.
 *  Drawn by cairo, without a display. y points up.
 *
 *  The map's longer side is at most 1600 px: a cell has up to 4 px each way (more where the map is
 *  tiny), or several cells share one. In the SVG the map is an embedded PNG. The same stages give
 *  the same bytes on one machine; another one may have other fonts. O(cells + path points). */
[[nodiscard]] std::string drawPng(const Stages& stages);
[[nodiscard]] std::string drawSvg(const Stages& stages);

}  // namespace roomgraph
