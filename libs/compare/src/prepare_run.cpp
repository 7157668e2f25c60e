#include "roomgraph/compare/prepare_run.h"

#include <utility>

#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/return_memory.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph {
namespace {

/** Takes what a run keeps of the extraction; the rest, which is several times as much, goes with
 *  the stages. Returns the map in its three states. */
Grid takeGraph(Stages stages, Run& run) {
  run.sha256 = stages.source.sha256;
  run.rooms = std::move(stages.result.rooms);
  run.graph = std::move(stages.result.graph);
  run.areas = std::move(stages.areas);
  run.areas.labels = {};
  return std::move(stages.grid);
}

/** Lists that have grown have room to spare, and a copy has none. */
template <class T>
void leaveNoSpareRoom(T& grown) {
  grown = T(std::as_const(grown));
}

/** A site may have hundreds of runs, and a large map half a gigabyte: one part after the other. */
void leaveNoSpareRoomIn(Run& run) {
  leaveNoSpareRoom(run.map.walls);
  leaveNoSpareRoom(run.map.depths);
  for (auto& nearest : run.map.nearest) leaveNoSpareRoom(nearest);
  leaveNoSpareRoom(run.map.freeCells);
  leaveNoSpareRoom(run.map.patches);
  leaveNoSpareRoom(run.rooms);
  leaveNoSpareRoom(run.graph);
  leaveNoSpareRoom(run.areas);
  leaveNoSpareRoom(run.scans);
}

}  // namespace

Run prepareRun(const std::string& name, const GreyMap& map, const std::vector<Keyframe>& scans,
               const ExtractOptions& options) {
  Run run;
  run.name = name, run.file = map.source.file;
  run.resolution = map.frame.resolution;
  const Grid grid = takeGraph(extract(map, options), run);
  returnMemory();
  run.map = wallMap(grid);
  if (run.map.walls.empty())
    throw DataError((map.source.file.empty() ? name : map.source.file) +
                    ": has no wall beside free space: a run must have some");
  run.scans = scanWalls(scans);
  run.map.hasScans = !run.scans.empty();
  leaveNoSpareRoomIn(run);
  return run;
}

}  // namespace roomgraph
