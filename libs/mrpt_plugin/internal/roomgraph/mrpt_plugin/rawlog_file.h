#pragma once
#include <string>
#include <vector>

#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/scans/PlacedScan.h"

namespace roomgraph {

// Ours
// In:   PlacedScans
// Out:  the bytes of a .rawlog file
// Next: a file

/** A log for MRPT's programs: for each scan an action, the way from the pose before it, and an
 *  observation, the scan. The first action leads from the origin, so a program that adds them up
 *  draws the map as the run has it, in its frame. Of robots in 3D the ways are those on the floor.
 *  Gzipped; the same scans give the same bytes. */
std::string rawlogBytes(const std::vector<PlacedScan>& scans);

/** The same seen from poses that are moved by `motion`. */
std::vector<PlacedScan> moved(std::vector<PlacedScan> scans, const Transform2D& motion);

}  // namespace roomgraph
