#include "roomgraph/compare/prepare_run.h"

#include <utility>

#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph {

Run prepareRun(const std::string& name, const GreyMap& map, const std::vector<Keyframe>& scans,
               const ExtractOptions& options) {
  Stages stages = extract(map, options);
  Run run;
  run.name = name, run.file = utf8Text(map.source.file), run.sha256 = stages.source.sha256;
  run.map = wallMap(stages.grid, {});
  if (run.map.walls.empty())
    throw DataError((map.source.file.empty() ? name : map.source.file) +
                    ": has no wall beside free space: a run must have some");
  run.rooms = std::move(stages.result.rooms);
  run.graph = std::move(stages.result.graph);
  run.areas = std::move(stages.areas);
  run.areas.labels = {};  // not needed any more
  run.resolution = map.frame.resolution;
  run.scans = scanWalls(scans);
  const Run& grown = run;
  return grown;  // a copy, which has no room to spare: a site may have hundreds of runs
}

}  // namespace roomgraph
