#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** Whether the file announces a CSimpleMap, under one of its names. */
bool isSimplemap(CheckedFile& file);

/** Reads a file whose head announces a CSimpleMap: gridOfScans(). */
GreyMap readSimplemap(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
