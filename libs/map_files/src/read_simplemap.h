#pragma once
#include "roomgraph/files/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** Whether the file announces a CSimpleMap, under one of its names. */
bool isSimplemap(CheckedFile& file);

/** Reads a file whose head announces a CSimpleMap, and builds a grid of its horizontal 2D range
 *  scans. The objects in it are taken apart here, with every count compared to the bytes that are
 *  left; MRPT only gets the finished scans. Observations of other classes are stepped over.
 *  Fills everything but the source's file and hash. */
GreyMap readSimplemap(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
