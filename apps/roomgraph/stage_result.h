#pragma once
#include <filesystem>
#include <string>

#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

/** Stages a file of a comparison, and returns its name with the folder.
 *  @throws UsageError where it would replace one of the maps that are compared. */
std::string stageResult(const Comparison& comparison, const std::filesystem::path& folder,
                        const std::string& name, const std::string& bytes, StagedFiles& staged);

}  // namespace roomgraph
