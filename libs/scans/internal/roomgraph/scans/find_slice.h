#pragma once
#include <mrpt/math/TPoint3D.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "roomgraph/grid/GridFrame.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/PlacedScan.h"
#include "roomgraph/scans/PointCloud.h"

namespace roomgraph {

// In:   the points of a site
// Out:  Slice
// Next: sliceScan

/** Where in space there are points: cubes of kCube, each once. */
class Voxels {
 public:
  static constexpr double kCube = 0.1;  ///< [m]

  /** Points farther than 10 km from the origin, or than 100 m above or below it, are left out. */
  void add(double x, double y, double z);
  bool empty() const { return cubes_.empty(); }

  struct Column {
    std::int32_t x = 0, y = 0;
  };
  /** The columns in which there is a point at each height, by height, then in no order. */
  std::vector<std::vector<Column>> layers() const;
  double lowest() const;  ///< of layers()[0], its lower face [m]

 private:
  std::unordered_set<std::uint64_t> cubes_;
};

/** A horizontal band of a site. */
struct Slice {
  double floor = 0;          ///< its height in the frame of the points [m]
  double low = 0, high = 0;  ///< of the band, above the floor [m]
  bool isFlat = false;       ///< all points lie in one plane, without a floor
  bool isFloorSeen = true;   ///< false: what lies lowest are the feet of walls
  bool isEmpty = false;      ///< no point lies in the band

  bool contains(double z) const { return isFlat || (z - floor >= low && z - floor <= high); }
};

/** Finds the floor, the lowest height at which much of the site is covered and below which not most
 *  of it lies, as it does below a ceiling; and the band above it in which walls have the longest
 *  straight pieces; below lintels, so that doors stay open. Bands equal within a twentieth: the
 *  lowest. options.sliceLow and .sliceHigh, where not both 0, are the band. */
Slice findSlice(const Voxels& voxels, const LoadGridOptions& options);

/** Throws DataError if the slice, which is of this file, is empty. */
void refuseEmptySlice(const Slice& slice, const std::string& file);

/** For people: "heights 0.6 to 1.1 m above the floor at -1 m". */
std::string sliceText(const Slice& slice);

/** How many of the cells lie in straight, thin pieces of at least ten, as those of walls do, along
 *  any of 36 directions. Cells may be repeated, and stand in any order. O(cells log cells). */
std::size_t countStraightCells(std::vector<Cell> cells);

/** The identity of a scan: of its valid ranges, and where the others are. */
std::uint64_t rangesId(const RangeScan& scan);

/** What a scanner at the place of the points' sensor (map <- sensor), all round and level, would
 *  have seen in the slice: of each direction the nearest point, and between two points of one
 *  surface what joins them. Other directions are invalid. Heights of the slice count from
 *  `ground`. Fills `from`, the id, and the ranges of the scan. */
PlacedScan sliceScan(const CloudPoints& points, const mrpt::poses::CPose3D& sensor, double ground,
                     const Slice& slice);

}  // namespace roomgraph
