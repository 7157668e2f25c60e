#include "roomgraph/pipeline/extract.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "roomgraph/areas/area_graph.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/rooms/cut_paths.h"
#include "roomgraph/rooms/room_ids.h"
#include "roomgraph/topology/topology_graph.h"
#include "roomgraph/voronoi/voronoi_graph.h"
#include "roomgraph/voronoi/voronoi_without.h"

namespace roomgraph {
namespace {

/** Paper III-D: a cut this near to the end of a path is none [m]. */
constexpr double kCutEpsilon = 1e-8;

class Stopwatch {
 public:
  explicit Stopwatch(std::vector<StageTiming>& timings) : timings_(timings) {}

  void lap(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    timings_.push_back({stage, std::chrono::duration<double>(now - last_).count()});
    last_ = now;
  }

 private:
  std::vector<StageTiming>& timings_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

bool hasAny(const Grid& grid, State state) {
  return std::find(grid.cells.begin(), grid.cells.end(), state) != grid.cells.end();
}

/** Of the disc that rooms are found with, no narrower than a path; 0 to split at doors [m]. */
double discRadius(const FindRoomsOptions& options, double resolution, double clearance) {
  const double radius = roomRadius(options, resolution);
  return radius > 0 ? std::max(radius, clearance) : 0;
}

/** III-B with one alpha, or ours. */
Regions findRegions(const VoronoiGraph& voronoi, const InsideFlags& isInside, const Stages& s) {
  KeepClearOptions anyPassage;
  anyPassage.minClearance = 0;
  const double resolution = s.grid.frame.resolution;
  const double minClearance = effectiveClearance(anyPassage, resolution);
  if (s.roomRadius > 0) return findRooms(voronoi, isInside, s.roomRadius, minClearance);
  return splitAtDoors(voronoi, isInside, minClearance, resolution, s.options.splitAtDoors);
}

/** On the map without clutter. Its diagram is as large as the other, and not needed for long. */
RegionOutlines outlineRegions(const Stages& s, Stopwatch& watch) {
  const VoronoiGraph voronoi = voronoiWithout(s.voronoi, s.sites, s.cleared.isClutter);
  const InsideFlags isInside = keepInside(voronoi, s.cleared.grid, s.options.keepInside);
  watch.lap("voronoi_without");
  const Regions regions = findRegions(voronoi, isInside, s);
  watch.lap("find_rooms");
  return regionOutlines(s.cleared.grid, voronoi, isInside, regions);
}

Note clutterNote(const std::vector<Clutter>& clutter) {
  const auto largest =
      std::max_element(clutter.begin(), clutter.end(),
                       [](const Clutter& a, const Clutter& b) { return a.size < b.size; });
  char text[120];
  std::snprintf(text, sizeof text,
                "%zu free-standing obstacles up to %.2f m large are taken for clutter and do not "
                "split rooms",
                clutter.size(), largest->size);
  return {"clutter", text, std::array<double, 2>{largest->center.x, largest->center.y}};
}

/** What was left out of the map, and why the result is empty or lacks rooms. */
void addNotes(Stages& s) {
  if (!s.cleared.clutter.empty()) s.notes.push_back(clutterNote(s.cleared.clutter));
  const auto note = [&](const char* code, const char* text) {
    s.notes.push_back({code, text, std::nullopt});
  };
  if (!hasAny(s.grid, State::free))
    note("no_free_cell", "the map has no free cell, so its graph is empty");
  else if (s.sites.cells.empty())
    note("no_obstacle", "the map has no obstacle, so there is nothing to keep clear of");
  else if (s.result.graph.vertices().empty())
    note("no_path", "no place of the map is wide enough for a path");
  else if (s.result.rooms.empty())
    note("no_room", "the map has no room, only corridors");
}

}  // namespace

Stages extract(const GreyMap& map, const ExtractOptions& options) {
  Stages s;
  s.options = options;
  s.source = map.source;
  s.notes = map.notes;
  const double resolution = map.frame.resolution;
  s.clearance = effectiveClearance(options.keepClear, resolution);
  s.roomRadius = discRadius(options.findRooms, resolution, s.clearance);
  const double minLength = shortLength(options.shortDeadEnds, resolution);
  Stopwatch watch(s.timings);

  // IV-C: threshold and thinning
  s.grid = binarize(map, options.binarize);
  watch.lap("binarize");
  // Without unknown cells a map is a drawing: beyond its border is outside, not unknown.
  const bool ringIsObstacle =
      options.thinObstacles.unknownIsObstacle && hasAny(s.grid, State::unknown);
  s.sites = obstacleSites(s.grid, thinObstacles(s.grid, options.thinObstacles), ringIsObstacle);
  watch.lap("obstacle_sites");

  // III-A: the topology graph
  s.voronoi = voronoiGraph(s.sites);
  watch.lap("voronoi_graph");
  s.isInside = keepInside(s.voronoi, s.grid, options.keepInside);
  watch.lap("keep_inside");
  s.clearEdges = keepClear(s.voronoi, s.isInside, s.clearance);
  watch.lap("keep_clear");
  s.topology = topologyGraph(s.voronoi, s.clearEdges);
  watch.lap("topology_graph");
  s.pruned = removeDeadEnds(s.topology, options.deadEnds, resolution);
  watch.lap("dead_ends");
  s.joinedUp = joinVertices(s.pruned, options.joinVertices, resolution);
  watch.lap("join_vertices");
  s.largest = keepLargest(s.joinedUp, options.keepLargest, s.notes);
  watch.lap("keep_largest");

  // III-B to III-G: the rooms
  s.cleared = clearClutter(s.grid, s.sites, options.clearClutter);
  watch.lap("clear_clutter");
  s.outlines = outlineRegions(s, watch);
  s.rooms = s.outlines.rooms();
  watch.lap("region_outlines");
  s.stretches = borderVertices(s.largest, s.rooms, s.clearance, kCutEpsilon);
  watch.lap("border_vertices");
  s.cut = roomIds(cutPaths(s.largest, s.stretches), s.rooms, minLength);
  watch.lap("cut_paths");
  s.cleaned = removeShortDeadEnds(s.cut, minLength);
  watch.lap("short_dead_ends");
  s.doors = joinDoors(s.cleaned, options.joinDoors);
  watch.lap("join_doors");
  s.result =
      roomGraph(s.doors, s.rooms, ObstacleRows(s.sites), s.clearance, options.roomGraph, s.notes);
  watch.lap("room_graph");
  s.areas = areaGraph(s.cleared.grid, s.outlines, s.result, s.clearance, s.notes);
  watch.lap("area_graph");
  addNotes(s);
  return s;
}

}  // namespace roomgraph
