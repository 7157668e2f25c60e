#include "roomgraph/consensus/run_submaps.h"

namespace roomgraph {
namespace {

void addScan(RunSubmaps& run, const ScanWalls& scan) {
  const auto index = std::uint32_t(run.submaps.size());
  run.submaps.push_back({scan.pose, scan.ends, scan.axes});
  if (index > 0) run.links.push_back({index - 1, index});
}

void addPatch(RunSubmaps& run, const WallPatch& patch, const WallMap& map) {
  const auto index = std::uint32_t(run.submaps.size());
  Submap submap;
  submap.pose = {patch.middle.x, patch.middle.y, 0};
  for (const std::uint32_t wall : patch.own)
    submap.points.add(map.walls[wall].place - patch.middle);
  run.submaps.push_back(submap);
  for (const std::uint32_t next : patch.neighbours)
    if (next > index) run.links.push_back({index, next});
}

}  // namespace

RunSubmaps runSubmaps(const Run& run) {
  RunSubmaps result;
  result.areScans = !run.scans.empty();
  for (const ScanWalls& scan : run.scans) addScan(result, scan);
  if (!result.areScans)
    for (const WallPatch& patch : run.map.patches) addPatch(result, patch, run.map);
  return result;
}

}  // namespace roomgraph
