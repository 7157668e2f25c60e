#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/grid/GreyMap.h"
#include "roomgraph/grid/Grid.h"
#include "roomgraph/scans/PlacedScan.h"

namespace roomgraph {

// In:   GreyMap, and the Grid that binarize made of it; PlacedScan
// Out:  the bytes of an MRPT grid map; those of a log
// Next: writeFileAtomically, loadGrid

/** The map as a COccupancyGridMap2D in the version that the installed MRPT writes, gzipped, with
 *  kGzipMark. Occupied and free cells keep their probabilities as far as MRPT's steps allow, all
 *  others become 0.5, so that loadGrid() gives the same Grid. Same map, same bytes. O(cells). */
std::string gridmapBytes(const GreyMap& map, const Grid& grid);

/** A log for MRPT's programs: for each scan an action, the way from the pose before it, and an
 *  observation, the scan. The first action leads from the origin, so a program that adds them up
 *  draws the map as the run has it, in its frame. Of robots in 3D the ways are those on the floor.
 *  Gzipped; the same scans give the same bytes. */
std::string rawlogBytes(const std::vector<PlacedScan>& scans);

/** The same seen from poses that are moved by `motion`. */
std::vector<PlacedScan> moved(std::vector<PlacedScan> scans, const Transform2D& motion);

}  // namespace roomgraph
