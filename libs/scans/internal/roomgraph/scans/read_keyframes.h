#pragma once
#include "roomgraph/base/checked_file.h"
#include "roomgraph/grid/LoadGridOptions.h"
#include "roomgraph/scans/Keyframe.h"
#include "roomgraph/scans/RobotScan.h"

namespace roomgraph {

/** What loadKeyframes() and loadScans() give of a file that is a simplemap. */
std::vector<Keyframe> readKeyframes(CheckedFile& file, const LoadGridOptions& options);
std::vector<RobotScan> readRobotScans(CheckedFile& file, const LoadGridOptions& options);

}  // namespace roomgraph
