#pragma once
#include <string>
#include <vector>

#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/Keyframe.h"

namespace roomgraph {

// In:   the name of a map file
// Out:  GreyMap
// Next: binarize

/** Reads a map, recognised by its content and never by its name. Any of these may be
 *  compressed with gzip or Zstandard:
 *  - MRPT COccupancyGridMap2D (`.gridmap`), stream versions 0 to 7. The grey levels equal what
 *    MRPT's own reader gives; the frame keeps the stored bounds and resolution.
 *  - MRPT CSimpleMap (`.simplemap`; also under its old name CSensFrameProbSequence), versions 0
 *    to 2: its horizontal 2D range scans, versions 0 to 8, are inserted into a grid of
 *    options.resolution just large enough for them, in the order of the file, with these
 *    options, which GreyMap::source.insertion records. Where it has none, or they ask for a slice,
 *    its point clouds (CObservationPointCloud, 3DRangeScan, VelodyneScan, RotatingScan; also those
 *    in files beside it) are cut to a horizontal band and inserted as scans are ("slice"). Where
 *    there is neither, scans that are tilted by up to 3 degrees are taken for level
 *    ("tilted_scans"). Other observations are stepped over and noted ("other_observations").
 *  - mp2p_icp::metric_map_t (`.mm`), versions 0 to 5: options.layer; else its first
 *    COccupancyGridMap2D; else a slice of its points, in which cells with floor are free ("layer").
 *  - rtabmap's database (`.db`): the 2D grid that it keeps when it is closed.
 *  - ROS map yaml with its picture, whose name counts from the yaml's directory. Modes trinary and
 *    scale use the yaml's thresholds; raw takes pixels of 0 to 100 as percent occupied, the rest as
 *    unknown, and uses the thresholds, too. Pixels that are not opaque are unknown. The cells of a
 *    map whose origin has a yaw are turned into the map frame ("turned"), as a grid here is always
 *    along its axes. Maps that ROS 2 Humble saved, whose free_thresh of 0.25 would make unknown
 *    cells free, are read with 0.196 ("humble_thresholds"). Where a threshold is missing, 0.65 or
 *    0.196 is taken ("default_thresholds"). source.sha256 is that of the yaml
 *    followed by the picture.
 *  - A bare picture (png of any depth, pgm, bmp, jpeg): options.resolution, with a note that it is
 *    a guess unless it was given ("assumed_resolution"); lower left corner at (0, 0). Transparent
 *    pixels show a mid-grey background, which means unknown.
 *
 *  A layer or a resolution that is given and of no use for this kind of map is noted, too
 *  (kUnusedOption).
 *
 *  No byte reaches MRPT's readers unchecked: sizes, counts and checksums are verified first, and
 *  nothing is allocated on the word of a header alone. At most 400 million cells. Peak memory for a
 *  gridmap: 2 bytes per cell besides the compressed file. Deterministic; O(file + cells). Prints
 *  nothing. Several threads may load at the same time.
 *  @throws DataError with one line (file, problem, remedy) where the file is missing, damaged,
 *  absurd or of no known kind. */
[[nodiscard]] GreyMap loadGrid(const std::string& file, const LoadGridOptions& options);

/** The code of notes on options that were given and of no use. */
constexpr char kUnusedOption[] = "unused_option";

/** A map, and what was seen where it was made. */
struct LoadedMap {
  GreyMap map;
  /** One for each scan, or slice, that the grid is made of, in the order of the file; empty for a
   *  map that holds none. Beams without return or longer than options.maxDistanceInsertion are
   *  left out. */
  std::vector<Keyframe> keyframes;
};
/** The same with its key frames: the file is opened, inflated and decoded once for both. */
[[nodiscard]] LoadedMap loadMap(const std::string& file, const LoadGridOptions& options);

}  // namespace roomgraph
