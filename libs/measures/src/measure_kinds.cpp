#include "roomgraph/measures/measure_kinds.h"

#include "roomgraph/relate/PairBend.h"

namespace roomgraph {
namespace {

constexpr double kWalls = kFewestWalls;
constexpr double kArea = 10;  // of the site [m2]
constexpr double kRooms = 3;
constexpr double kCount = 10;   // vertices, paths, or pairs of vertices
constexpr double kLength = 20;  // of paths [m]
constexpr double kScans = 10;

}  // namespace

const std::vector<MeasureKind>& runMeasureKinds() {
  static const std::vector<MeasureKind> kinds{
      {"coverage", "Coverage", "1", 0, "Of what two runs have seen free, the share it has seen."},
      {"bend", "Bend away from the others", "m", kWalls, "Mean bend against the others, by trust."},
      {"axis_deviation", "Walls off right angles, median", "deg", 0,
       "Median angle between its walls and the nearer of its two main directions."},
      {"wall_distance", "Wall distance, median", "m", kWalls,
       "Median distance of its walls to those of the others."},
      {"wall_distance_p90", "Wall distance, 9 of 10 below", "m", kWalls,
       "90th percentile of the same distances."},
      {"rooms_matched", "Rooms found again", "1", kRooms,
       "Of the rooms of the others that it has seen, the share it has, too."},
      {"room_coverage", "Room area of the others that it has", "1", kArea,
       "Of the area of all rooms of the others, the share in rooms that it has, too."},
      {"path_coverage", "Paths of the others that it has", "1", kLength,
       "Of the path length of the others, the share it has, too."},
      {"global_accuracy", "Vertices off, RMS", "m", kCount,
       "RMS distance of matched vertices in the frame of the site."},
      {"relative_accuracy", "Vertices off after the best fit, RMS", "m", kCount,
       "The same after the turn and shift that fit each pair best."},
      {"consistency_1", "Distances off, 1 hop", "1", kCount,
       "Median error of distances between vertices one path apart."},
      {"consistency_2", "Distances off, 2 hops", "1", kCount, "The same, two paths apart."},
      {"consistency_4", "Distances off, 4 hops", "1", kCount, "The same, four paths apart."},
      {"consistency_8", "Distances off, 8 hops", "1", kCount, "The same, eight paths apart."},
      {"path_length_error", "Path lengths off, median", "1", kCount,
       "Median error of the lengths of matched paths."},
      {"path_frechet", "Paths apart (Fréchet), median", "m", kCount,
       "Median Fréchet distance of matched paths, their ends laid on each other."},
      {"nearest_vertex", "Nearest vertex, mean", "m", kCount,
       "Mean distance of its vertices to the nearest vertex of the other."},
      {"brokenness", "Extra pieces", "pieces", kWalls, "Rigid pieces of the map, less one."},
      {"wall_doubling", "Walls drawn twice", "1", kWalls,
       "Share of its walls that stand before another one that faces the same way."},
      {"wall_sharpness", "Wall at the edge of free space", "1", kWalls,
       "Cells drawn as wall for each cell at the edge of free space."},
      {"scan_disagreement", "Scans off another visit, 9 of 10 below", "m", kScans,
       "How far scans lie from what was seen at the same place at another time."}};
  return kinds;
}

const std::vector<MeasureKind>& pairMeasureKinds() {
  static const std::vector<MeasureKind> kinds{
      {"followed", "Walls found again", "1", kWalls, "Share of the walls that both have."},
      {"wall_distance_mean", "Wall distance, mean", "m", kWalls,
       "Mean distance of the walls of both."}};
  return kinds;
}

const MeasureKind* findMeasureKind(const std::string& name) {
  for (const auto* kinds : {&runMeasureKinds(), &pairMeasureKinds()})
    for (const MeasureKind& kind : *kinds)
      if (kind.name == name) return &kind;
  return nullptr;
}

}  // namespace roomgraph
