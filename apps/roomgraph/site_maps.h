#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

/** Each run as a ROS map in the frame of the site (comparison.RUN.yaml and .pgm), its pose in that
 *  frame, and a session of the viewer "maps" with all of them. Returns their names.
 *  @throws DataError where a run cannot be read any more; UsageError where one of them would
 *  replace a run. */
std::vector<std::string> addSiteMaps(const Comparison& comparison, const ExtractOptions& options,
                                     const std::filesystem::path& folder, StagedFiles& staged);

}  // namespace roomgraph
