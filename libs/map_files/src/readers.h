#pragma once
#include <charconv>
#include <cstdint>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"

namespace roomgraph {

/** What a cell of log-odds `cell` looks like: 255 * (1 - p(occupied)), rounded. */
std::uint8_t greyOfLogOdds(int cell);

/** Whether the file announces a COccupancyGridMap2D. */
bool isGridmap(CheckedFile& file);

/** Reads a file whose head announces a COccupancyGridMap2D. The cells come straight out of the
 *  checked bytes: MRPT's reader believes sizes that contradict the bounds, and needs a second copy
 *  of all the cells. Fills everything but the source's file and hash. */
GreyMap readGridmap(CheckedFile& file, const LoadGridOptions& options);

/** Reads a COccupancyGridMap2D object, from its header to its end, as readGridmap() does. */
GreyMap readGridmapObject(ByteReader& reader);

/** Whether the file is an SQLite database. */
bool isRtabmap(CheckedFile& file);

/** Reads the 2D grid that rtabmap (0.17 and later) keeps in its database when it is closed: row
 *  "Admin", columns opt_map, opt_map_x_min, opt_map_y_min and opt_map_resolution [m]. opt_map is a
 *  matrix of cv::Mat that rtabmap has packed: zlib's stream of the cells by row, the lowest first,
 *  then rows, columns and the type of OpenCV, each an int32. A cell is -1 (unknown) or 0 to 100
 *  percent occupied. Fills everything but the source's file and hash. Throws DataError where the
 *  database is damaged, of another program, or has no grid. */
GreyMap readRtabmap(CheckedFile& file, const LoadGridOptions& options);

/** Whether the file is a text with a key 'image'. */
bool isRosMap(CheckedFile& file);

/** The name of the picture that it names. Throws DataError like readRosMap. */
std::string pictureOfRosMap(CheckedFile& file);

/** Reads a ROS map: a yaml that names a picture. Fills everything but the source's file. Throws
 *  DataError where a value is missing or absurd, or the picture cannot be read; then the message
 *  starts with the picture's name. */
GreyMap readRosMap(CheckedFile& file, const LoadGridOptions& options);

/** Whether the file announces a mp2p_icp::metric_map_t, what MOLA keeps its maps in. */
bool isMetricMap(CheckedFile& file);

/** Reads one layer of a metric map: a grid as it is, points as a slice in which the floor is free.
 *  Fills everything but the source's file and hash. Throws DataError where the layer is not there,
 *  is of another class, or its points have no floor. */
GreyMap readMetricMap(CheckedFile& file, const LoadGridOptions& options);

/** What the writer meant where a file keeps single precision: 0.05 is stored as 0.0500000007. */
inline double decimal(float value) {
  const std::string text = numberText(value);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

/** The grey of a cell that is occupied with this probability [%], as ROS keeps its grids. */
inline std::uint8_t greyOfPercent(int percent) {
  return std::uint8_t((255 * (100 - percent) + 50) / 100);
}

}  // namespace roomgraph
