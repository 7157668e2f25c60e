#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** Whether the file is an SQLite database. */
bool isRtabmap(CheckedFile& file);

/** Reads the 2D grid that rtabmap (0.17 and later) keeps in its database when it is closed: row
 *  "Admin", columns opt_map, opt_map_x_min, opt_map_y_min and opt_map_resolution [m]. opt_map is a
 *  matrix of cv::Mat that rtabmap has packed: zlib's stream of the cells by row, the lowest first,
 *  then rows, columns and the type of OpenCV, each an int32. A cell is -1 (unknown) or 0 to 100
 *  percent occupied. Fills everything but the source's file and hash. Throws DataError where the
 *  database is damaged, of another program, or has no grid. */
GreyMap readRtabmap(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
