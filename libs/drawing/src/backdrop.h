#pragma once
#include "View.h"
#include "roomgraph/images/png_bytes.h"

namespace roomgraph {

/** The grid as a picture that the graph is drawn on: free white, unknown grey, occupied dark.
 *  Where a pixel stands for several cells an occupied one wins, so that no wall gets lost, then a
 *  free one. Not yet magnified. */
PaletteImage backdrop(const Grid& grid, const View& view);

/** The colours that `backdrop` uses, for the legend. */
Colour stateColour(State state);

}  // namespace roomgraph
