#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "roomgraph/grid/add_wall_noise.h"
#include "roomgraph/measures/match_elements.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph {

// Paper IV-C: how much of a graph stays where it is when the walls are noisy
// In:   GreyMap
// Out:  Stability
// Next: stabilityCsv, stabilityJson, stabilityText
//
// In parts, for those who run them side by side: stabilityRuns -> stabilityBase -> measureRun ->
// summarizeStability. All distances are in metres, whatever the files say.

struct StabilityOptions {
  /** The paper's text has 1, 2, 3, 5; the columns of its tables say 1 to 4. */
  std::vector<int> distances{1, 2, 3, 5};         ///< d_r [px]
  std::vector<double> percents{2, 5, 8, 11, 14};  ///< p
  int repeats = 10;                               ///< noisy maps for each of these
  std::uint64_t seed = 1;
  int baseDistance = 5;    ///< d_r of the map that all others are compared with [px]
  double basePercent = 2;  ///< p of that map
  double matchWithin = 1;  ///< how far apart the same vertex may be [m]
};

/** One noisy map. Its noise has a seed of its own, made of options.seed, distance, percent and
 *  repeat, so it is the same whichever others are made, and in whatever order. */
struct StabilityRun {
  WallNoise noise;
  int repeat = 0;
};

/** All of them by distance, then percent, then repeat. Throws UsageError for an empty list, a
 *  value out of range, one that is listed twice, or no repeats. */
std::vector<StabilityRun> stabilityRuns(const StabilityOptions& options);

/** What all noisy maps are compared with. */
struct StabilityBase {
  Grid grid;  ///< without noise
  ExtractOptions extract;
  double matchWithin = 0;  ///< [m]
  TopologyGraph noRoom;    ///< of the base map: Stages::largest
  RoomGraph room;          ///< of the base map: Stages::result
};

/** The noise acts on the thresholded map, before thinning. */
StabilityBase stabilityBase(const GreyMap& map, const ExtractOptions& extract,
                            const StabilityOptions& options);

/** How far two graphs are apart. None where that has no meaning, as for an empty graph. */
struct GraphDistance {
  std::optional<double> nearest;  ///< the paper's measure [m]
  VertexAgreement agreement;      ///< one to one
};

struct RunMeasures {
  GraphDistance room, noRoom;
  std::optional<double> roomsFound;  ///< share of the base's rooms, 0 to 1; none if it has none
  int rooms = 0;                     ///< of the noisy map
};

/** Makes the noisy map and its graphs, and compares. Pure: any thread, any order. Cost: that of
 *  extract() and of nearestVertices(). */
RunMeasures measureRun(const StabilityBase& base, const StabilityRun& run);

/** The mean of all repeats of one noise. Where a repeat has no nearest distance or unmatched share,
 *  there is no mean; repeats without a pair are left out of the other distances. */
struct StabilityRow {
  int distance = 0;  ///< [px]
  double percent = 0;
  GraphDistance room, noRoom;
  std::optional<double> ratio;       ///< of the paper's measures, room / no room
  std::optional<double> roomsFound;  ///< share, 0 to 1
  double roomsChange = 0;            ///< mean of |rooms of the noisy map - rooms of the base|
};

struct Stability {
  StabilityOptions options;
  ExtractOptions extract;
  GreyMap::Source source;
  GridFrame frame;
  std::size_t baseVerticesRoom = 0, baseVerticesNoRoom = 0, baseRooms = 0;
  std::vector<StabilityRun> runs;
  std::vector<RunMeasures> measures;  ///< one per run
  std::vector<StabilityRow> rows;     ///< by distance, then percent
  StabilityRow mean;                  ///< of the rows; mean.ratio is the mean of their ratios
};

/** `measures` must be those of stabilityRuns(options), in that order. */
Stability summarizeStability(const GreyMap& map, const StabilityBase& base,
                             const StabilityOptions& options, std::vector<RunMeasures> measures);

}  // namespace roomgraph
