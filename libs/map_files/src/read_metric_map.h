#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** Whether the file announces a mp2p_icp::metric_map_t, what MOLA keeps its maps in. */
bool isMetricMap(CheckedFile& file);

/** Reads one layer of a metric map: a grid as it is, points as a slice in which the floor is free.
 *  Fills everything but the source's file and hash. Throws DataError where the layer is not there,
 *  is of another class, or its points have no floor. */
GreyMap readMetricMap(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
