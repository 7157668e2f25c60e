#pragma once
#include <optional>
#include <vector>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/consensus/track_scans.h"

namespace roomgraph::test {

/** A building, and a drive through it. */
struct DriveInBuilding {
  Grid grid = drawnBuilding(4, {});
  WallMap map = wallMap(grid);
  std::vector<Keyframe> frames = drawnDrive(grid);

  /** Where the scans of a drive, which may be torn, lie in the map of the building. */
  std::vector<std::optional<Transform2D>> trackOf(const std::vector<Keyframe>& driven) const {
    return trackScans(scanWalls(driven), map.patches, followWalls(map, map, {{}}), {{}}, map);
  }
};

/** The same for all tests of a program. */
inline const DriveInBuilding& driveInBuilding() {
  static const DriveInBuilding the;
  return the;
}

}  // namespace roomgraph::test
