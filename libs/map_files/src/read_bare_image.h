#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

bool isBareImage(CheckedFile& file);

/** Reads a picture without a yaml as a map, at options.resolution. Fills everything but the
 *  source's file and hash. */
GreyMap readBareImage(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
