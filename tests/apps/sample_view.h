#pragma once
#include "View.h"

namespace roomgraph::test {

/** Two runs along a line, the second with a break at its key frame 12 of 30; a room round them. */
View sampleView();

/** The same, with walls to draw. */
View viewWithMaps();

/** One map of two rooms, extracted. */
View viewOfMap();

}  // namespace roomgraph::test
