#pragma once
#include <string>
#include <vector>

#include "roomgraph/base/StagedFiles.h"
#include "roomgraph/pipeline/Stages.h"

namespace roomgraph {

// In:   Stages
// Out:  a folder with a picture of each step

/** The names of the files of drawStages(). */
[[nodiscard]] std::vector<std::string> stageFiles();

/** Adds to `files` one PNG for each step in `folder`, which is made if it is not there: 01_grid.png
 *  to 16_areas.png in the order of the pipeline, each with the section of the paper in its title;
 *  and stages.json with the counts: {"format": "roomgraph/stages", "version": 1, "stages":
 *  [{"file", "paper", "title", "counts": {name: number}}]}. Same stages, same bytes.
 *  @throws DataError where a file or the folder cannot be written. */
void drawStages(const Stages& stages, const std::string& folder, StagedFiles& files);

}  // namespace roomgraph
