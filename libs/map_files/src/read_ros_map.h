#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** Whether the file is a text with a key 'image'. */
bool isRosMap(CheckedFile& file);

/** The name of the picture that it names. Throws DataError like readRosMap. */
std::string pictureOfRosMap(CheckedFile& file);

/** Reads a ROS map: a yaml that names a picture. Fills everything but the source's file. Throws
 *  DataError where a value is missing or absurd, or the picture cannot be read; then the message
 *  starts with the picture's name. */
GreyMap readRosMap(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
