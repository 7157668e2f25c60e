#pragma once
#include <string>
#include <vector>

#include "roomgraph/align/WallMap.h"
#include "roomgraph/align/scan_walls.h"
#include "roomgraph/rooms/AreaGraph.h"
#include "roomgraph/rooms/RoomGraph.h"

namespace roomgraph {

/** What the comparison needs to know of a run. */
struct Run {
  std::string name, file, sha256;  ///< of its map; `name` is unique
  WallMap map;                     ///< must have walls
  std::vector<GraphRoom> rooms;    ///< in the frame of the run
  std::vector<ScanWalls> scans;    ///< of a simplemap; else empty
  AreaGraph areas{};               ///< in the frame of the run; without labels
  TopologyGraph graph{};           ///< that of the RoomGraph, in the frame of the run
  double resolution = 0;           ///< side of a cell of the map as it was read [m]
  bool isScaleEstimated = false;   ///< `resolution` is estimateScale's, not the file's
};

/** The run of this name, as it is or compared; null where there is none. O(runs). */
template <class OneRun>
[[nodiscard]] const OneRun* findRun(const std::vector<OneRun>& runs, const std::string& name) {
  for (const OneRun& run : runs)
    if (run.name == name) return &run;
  return nullptr;
}

/** The order of sortRuns. */
[[nodiscard]] bool isBefore(const Run& l, const Run& r);

/** Brings runs into the order that all results are computed in, by content and then by name, so
 *  that the order in which they are given changes no number. */
void sortRuns(std::vector<Run>& runs);

}  // namespace roomgraph
