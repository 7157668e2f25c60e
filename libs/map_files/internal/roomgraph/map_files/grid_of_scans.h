#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** The grid that MRPT builds of a simplemap's horizontal 2D range scans. Its objects are taken
 *  apart here, with every count compared to the bytes that are left; MRPT only gets the finished
 *  scans. Observations of other classes are stepped over. Fills everything but the source's file
 *  and hash. */
GreyMap gridOfScans(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
