#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/compare/Comparison.h"
#include "roomgraph/ledger/SiteFile.h"
#include "roomgraph/pipeline/ExtractOptions.h"

namespace roomgraph {

/** The rooms of a site as a file of names knows them; nothing where there is no such file. */
SiteFile readSite(const std::string& file);

/** The path of each run with scans in the frame of the site (comparison.RUN.tum), and the error
 *  along it for evo_res (comparison.RUN.evo.zip). Returns their names.
 *  @throws UsageError where one of them would replace a run. */
std::vector<std::string> addTrajectories(const Comparison& comparison,
                                         const std::filesystem::path& folder, StagedFiles& staged);

/** Each run as a ROS map in the frame of the site (comparison.RUN.yaml and .pgm), its pose in that
 *  frame, and a session of the viewer "maps" with all of them. Returns their names.
 *  @throws DataError where a run cannot be read any more; UsageError where one of them would
 *  replace a run. */
std::vector<std::string> addSiteMaps(const Comparison& comparison, const ExtractOptions& options,
                                     const std::filesystem::path& folder, StagedFiles& staged);

}  // namespace roomgraph
