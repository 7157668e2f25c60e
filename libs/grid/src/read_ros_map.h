#pragma once
#include <optional>

#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/checked_file.h"

namespace roomgraph {

/** Reads a ROS map: a yaml that names a picture. Nothing comes back for a text that is no such
 *  yaml. Fills everything but the source's file. Throws DataError where a value is missing or
 *  absurd, or the picture cannot be read; then the message starts with the picture's name. */
std::optional<GreyMap> readRosMap(CheckedFile& file);

}  // namespace roomgraph
