#pragma once
#include <string>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/images/png_bytes.h"

namespace roomgraph {

/** A map of a run, where it lies in the site. */
struct PlacedMap {
  const WallMap* map = nullptr;
  Transform2D pose;  ///< site <- run
};

/** A picture that is to be laid over a part of the site, y up. */
struct SitePicture {
  Box box;          ///< of the site [m]; the unit square where there is nothing to show
  std::string png;  ///< transparent where nothing is known; empty where there is nothing to show
};

/** The smallest upright box round all that is known of the maps [m]; the unit square for nothing.
 */
Box knownBox(const std::vector<PlacedMap>& maps);

/** How large a pixel must be so that the site has no more pixels on its longer side than `most`,
 *  and no less than half a cell of the finest map [m]. */
double pixelFor(const Box& site, const std::vector<PlacedMap>& maps, int most);

/** How the map of a run is drawn. */
struct RunInk {
  Colour colour;                           ///< of its walls
  RunPattern pattern = RunPattern::solid;  ///< of its walls; what is left out is drawn weakly
  std::uint8_t faint = 30;                 ///< opacity of its free space, of 255
};

/** The walls of one map and, in a faint tint of them, its free space. The pixels of all maps lie on
 *  one raster. O(pixels). */
SitePicture runPicture(const PlacedMap& map, const RunInk& ink, double pixel);

/** Where the runs disagree: a share of the runs that have looked at a place and are in the minority
 *  there, "wall" or "free", 0 to 1/2. */
struct Disagreement {
  GridFrame frame;            ///< of the site
  std::vector<float> shares;  ///< per cell, row-major; 0 where fewer than two runs have looked
};

/** A run says "wall" where it has one in the cell, and "free" where it knows free space there and
 *  has no wall in the cell or the eight round it. Cells of `cell` [m]. O(runs * cells). */
Disagreement disagreementOf(const std::vector<PlacedMap>& maps, double cell);

/** Colours of the heat map: shares up to 1/10, 2/10 and so on, pale to dark. */
const std::vector<Colour>& heatColours();

/** Which of them a share has, from 1; 0 for none. */
int heatLevel(double share);

SitePicture heatPicture(const Disagreement& disagreement);

}  // namespace roomgraph
