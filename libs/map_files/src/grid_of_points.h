#pragma once
#include <mrpt/math/TPoint3D.h>

#include <string>
#include <vector>

#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/scans/find_slice.h"

namespace roomgraph {

/** A grid of points alone, which nobody tells from where they were seen: cells with points in the
 *  slice are occupied, others where the floor is seen are free, and so are gaps in the floor of up
 *  to 0.3 m. Throws DataError, in the name of `file`, for more than kMostCells. O(points +
 *  cells). */
GreyMap gridOfPoints(const std::vector<mrpt::math::TPoint3Df>& points, const Slice& slice,
                     double resolution, const std::string& file);

}  // namespace roomgraph
