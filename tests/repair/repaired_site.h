#pragma once
#include <vector>

#include "drawn_building.h"
#include "drawn_drive.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/repair/rejoin_pieces.h"

namespace roomgraph::test {

/** A drive through a building, with scans that no other drive has. */
inline std::vector<Keyframe> drive(std::uint64_t log) {
  std::vector<Keyframe> frames = drawnDrive(drawnBuilding(4, {}));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    frames[k].scanId = 1000 * log + k;
    frames[k].number = 2 * k;
  }
  return frames;
}

/** Runs that have drawn their maps from their scans, and what they tell together. */
struct SolvedDrives {
  std::vector<Run> runs;
  SolvedSite solved;
  RealPoses real;

  explicit SolvedDrives(const std::vector<std::vector<Keyframe>>& drives,
                        std::optional<std::size_t> reference = {})
      : runs(runsOf(drives)),
        solved(solveSite(runs, related(runs), reference, oneByOne)),
        real(rejoinPieces(solved)) {}
  SolvedDrives(const SolvedDrives&) = delete;

  static std::vector<Run> runsOf(const std::vector<std::vector<Keyframe>>& drives) {
    std::vector<Run> runs;
    for (const std::vector<Keyframe>& frames : drives) {
      Run& run = runs.emplace_back();
      run.name = "run" + std::to_string(runs.size());
      run.map = wallMap(mapDrawnBy(frames));
      run.scans = scanWalls(frames);
    }
    return runs;
  }
};

/** A torn drive between two that drift a little. */
inline const SolvedDrives& tornAmongSound() {
  static const SolvedDrives the({drifting(drive(1), 0.0003), broken(drive(2), 20, 0.6, {2, 1}),
                                 drifting(moved(drive(3), {5, -3, 1}), -0.0003)});
  return the;
}

}  // namespace roomgraph::test
