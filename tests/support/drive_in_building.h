#pragma once
#include <optional>
#include <vector>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/consensus/track_scans.h"

namespace roomgraph::test {

/** trackScans() without what other calls have found. */
inline std::vector<std::optional<Transform2D>> trackOnce(const std::vector<ScanWalls>& scans,
                                                         const WallPatches& patches,
                                                         const FollowedWalls& followed,
                                                         const std::vector<Transform2D>& wholes,
                                                         const WallMap& in) {
  TrackedFits fits;
  return trackScans(scans, patches, followed, {wholes, {}}, in, fits);
}

/** A building, and a drive through it. */
struct DriveInBuilding {
  Grid grid = drawnBuilding(4, {});
  WallMap map = wallMap(grid);
  std::vector<Keyframe> frames = drawnDrive(grid);

  /** Where the scans of a drive, which may be torn, lie in the map of the building. */
  std::vector<std::optional<Transform2D>> trackOf(const std::vector<Keyframe>& driven) const {
    return trackOnce(scanWalls(driven), map.patches, followWalls(map, map, {{}}), {{}}, map);
  }
};

/** The same for all tests of a program. */
inline const DriveInBuilding& driveInBuilding() {
  static const DriveInBuilding the;
  return the;
}

}  // namespace roomgraph::test
