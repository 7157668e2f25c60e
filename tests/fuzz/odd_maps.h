#pragma once
#include "ByteSource.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph::test {

/** A map of up to 64 x 64 cells that nobody would drive: noise of three states, checkerboards,
 *  combs of one-cell corridors, strokes, rows of one cell; at any scale, anywhere on Earth. */
GreyMap oddMap(ByteSource& bytes);

/** The default options, or the paper's, with some of them anywhere in their ranges. */
ExtractOptions oddOptions(ByteSource& bytes);

}  // namespace roomgraph::test
