#pragma once
#include "roomgraph/grid/Grid.h"
#include "roomgraph/images/png_bytes.h"

namespace roomgraph {

/** How the known part of a map lies on a picture: which cells, and how large. Cells and pixels are
 *  counted from the lower left and the upper left; y points up in the map and on the picture. */
struct View {
  Cell first;                 ///< lower left cell shown; the margin may reach beyond the grid
  int columns = 0, rows = 0;  ///< cells shown
  int magnify = 1;            ///< pixels for each cell ...
  int reduce = 1;             ///< ... or cells for each pixel; one of the two is 1
  GridFrame frame;

  int imageWidth() const { return (columns + reduce - 1) / reduce; }  ///< before magnifying
  int imageHeight() const { return (rows + reduce - 1) / reduce; }
  int widthPx() const { return imageWidth() * magnify; }
  int heightPx() const { return imageHeight() * magnify; }
  double pxPerMetre() const { return double(magnify) / reduce / frame.resolution; }
  /** The place on the picture [px, y down]. */
  Point px(Point map) const;
};

/** All cells that are not unknown, with a margin; the whole grid where all are. */
View viewOf(const Grid& grid);

/** The grid as a picture that the graph is drawn on: free white, unknown grey, occupied dark.
 *  Where a pixel stands for several cells an occupied one wins, so that no wall gets lost, then a
 *  free one. Not yet magnified. */
PaletteImage backdrop(const Grid& grid, const View& view);

/** The colours that `backdrop` uses, for the legend. */
Colour stateColour(State state);

}  // namespace roomgraph
