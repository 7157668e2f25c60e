#pragma once
#include "Scene.h"
#include "View.h"

namespace roomgraph {

/** Where everything stands on the sheet, in px from its upper left corner. */
struct Layout {
  int width = 0, height = 0;
  Point map;                  ///< upper left corner of the map
  std::vector<Point> legend;  ///< middle of each item's symbol
  Point scaleBar;             ///< its left end
};

/** Title on top, map, legend in as many rows as it needs with the scale bar before it. */
Layout layoutOf(const Scene& scene, const View& view);

/** Title, border of the map, legend and scale bar. */
void drawFrame(cairo_t* cairo, const Scene& scene, const View& view, const Layout& layout);

/** The longest of 1, 2 or 5 times a power of ten that is not longer than `length`, > 0 [m]. */
double roundLength(double length);

}  // namespace roomgraph
