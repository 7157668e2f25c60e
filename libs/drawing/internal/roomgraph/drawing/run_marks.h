#pragma once
#include <cstddef>

#include "roomgraph/images/Colour.h"

namespace roomgraph {

/** How a run is told from the others, by its place in the ranking: colour and shape repeat after 14
 *  and 6 runs, so 42 runs in a row have different marks. The first 7 colours are those of Okabe and
 *  Ito that show on white. */
Colour runColour(std::size_t run);

/** How its walls are drawn: in full those of the first 7 runs, then striped one way, the other way,
 *  and dotted, those of 7 runs each; so 28 runs in a row have different walls. */
enum class RunPattern { solid, rising, falling, dotted };
RunPattern runPattern(std::size_t run);

/** An SVG path within -6 to 6, y down. */
const char* runShape(std::size_t run);

}  // namespace roomgraph
