#pragma once
#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/relate/Run.h"

namespace roomgraph::test {

/** A run with scans, all in a frame of its own. */
inline Run drivenRun() {
  const Grid grid = drawnBuilding(4, {});
  Run run;
  run.map = wallMap(grid);
  run.scans = scanWalls(drawnDrive(grid));
  return run;
}

/** A run of walls alone. */
inline Run scanlessRun() {
  Run run;
  run.map = wallMap(drawnBuilding(4, {3, -2, 0.5}));
  return run;
}

}  // namespace roomgraph::test
