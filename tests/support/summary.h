#pragma once
#include "MapText.h"
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph::test {

/** What came out, in the words of a drawing's header. The rooms get the names of the letters drawn
 *  into them; '?' stands for a room without a letter. */
Expected summarize(const Stages& stages, const MapText& text);

/** One line per difference; empty where the result is what the drawing's header says. */
std::string differenceFromExpected(const Stages& stages, const MapText& text);

}  // namespace roomgraph::test
