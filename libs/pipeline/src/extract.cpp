#include "roomgraph/pipeline/extract.h"

#include <algorithm>
#include <utility>

#include "StepTimer.h"
#include "roomgraph/areas/area_graph.h"
#include "roomgraph/areas/drop_half_seen.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/grid/wall_obstacles.h"
#include "roomgraph/rooms/RoomIndex.h"
#include "roomgraph/rooms/cut_paths.h"
#include "roomgraph/rooms/room_ids.h"
#include "roomgraph/topology/pass_clutter.h"
#include "roomgraph/topology/topology_graph.h"
#include "roomgraph/voronoi/voronoi_graph.h"
#include "roomgraph/voronoi/voronoi_without.h"

namespace roomgraph {
namespace {

/** Paper III-D: a cut this near to the end of a path is none [m]. */
constexpr double kEpsilon = 1e-8;

bool hasAny(const Grid& grid, State state) {
  return std::find(grid.cells.begin(), grid.cells.end(), state) != grid.cells.end();
}

/** Of the disc that rooms are found with, no narrower than a path; 0 to split at doors [m]. */
double discRadius(const FindRoomsOptions& options, double resolution, double clearance) {
  const double radius = roomRadius(options, resolution);
  return radius > 0 ? std::max(radius, clearance) : 0;
}

/** What the steps need to know of the map and the options. */
Stages prepared(const GreyMap& map, const ExtractOptions& options) {
  Stages s;
  s.options = options;
  s.source = map.source;
  s.notes = map.notes;
  s.clearance = effectiveClearance(options.keepClear, map.frame.resolution);
  s.roomRadius = discRadius(options.findRooms, map.frame.resolution, s.clearance);
  return s;
}

/** Without unknown cells a map is a drawing: beyond its border is outside, not unknown. */
bool ringIsObstacle(const Stages& s) {
  return s.options.thinObstacles.unknownIsObstacle && hasAny(s.grid, State::unknown);
}

/** III-B with one alpha, or ours. */
Regions findRegions(const VoronoiGraph& voronoi, const InsideFlags& isInside, const Stages& s) {
  KeepClearOptions anyPassage;
  anyPassage.minClearance = 0;
  const double resolution = s.grid.frame.resolution;
  const double minClearance = effectiveClearance(anyPassage, resolution);
  if (s.roomRadius > 0) return findRooms(voronoi, isInside, s.roomRadius, minClearance);
  return splitAtDoors(voronoi, isInside, wallObstacles(s.grid, s.obstacles), minClearance,
                      resolution, s.options.splitAtDoors);
}

/** On the map without clutter. Its diagram is as large as the other, and not needed for long. */
RegionOutlines outlineRegions(const Stages& s, const StepTimer& timed) {
  const VoronoiGraph voronoi =
      timed("voronoi_without", voronoiWithout, s.voronoi, s.obstacles, s.cleared.isClutter);
  const InsideFlags isInside =
      timed("keep_inside", keepInside, voronoi, s.cleared.grid, s.options.keepInside);
  const Regions regions = timed("find_rooms", findRegions, voronoi, isInside, s);
  return timed("region_outlines", regionOutlines, s.cleared.grid, voronoi, isInside, regions);
}

Note clutterNote(const std::vector<Clutter>& clutter) {
  const auto largest =
      std::max_element(clutter.begin(), clutter.end(),
                       [](const Clutter& a, const Clutter& b) { return a.size < b.size; });
  return {"clutter",
          formatted("%zu free-standing obstacles up to %.2f m large are taken for clutter and do "
                    "not split rooms",
                    clutter.size(), largest->size),
          std::array<double, 2>{largest->center.x, largest->center.y}};
}

/** Free width of the largest disc in an area [m]. */
double freeWidth(const Area& area, double resolution) {
  return 2 * (area.inscribedRadius - resolution / 2);
}

/** Where narrow regions outnumber the rooms, people miss them. */
void noteNarrowRegions(Stages& s) {
  const SplitAtDoorsOptions& options = s.options.splitAtDoors;
  if (s.roomRadius > 0) return;
  const auto isNarrow = [&](const Area& a) {
    const double width = freeWidth(a, s.grid.frame.resolution);
    return !a.isRoom() && width < options.openRoomWidth &&
           area(a.polygon) <= options.maxElongation * width * width;
  };
  const auto count = std::count_if(s.areas.areas.begin(), s.areas.areas.end(), isNarrow);
  if (std::size_t(count) <= s.result.rooms.size()) return;
  s.notes.push_back(
      {"narrow_regions",
       formatted("%td regions narrower than %.2f m are not closed by doors and count as corridor: "
                 "--set split_at_doors.open_room_width=%.2g makes rooms of them",
                 count, options.openRoomWidth, options.minRoomWidth),
       std::nullopt});
}

/** Slivers between single beams, hundreds on some maps, are not worth a word. */
void noteHalfSeen(Stages& s) {
  double largest = s.options.splitAtDoors.maxLeftoverArea;
  std::size_t count = 0;
  Point at;
  for (const Room& region : s.outlines.halfSeen()) {
    const double size = area(region.polygon);
    if (size < s.options.splitAtDoors.maxLeftoverArea) continue;
    ++count;
    if (size >= largest) largest = size, at = region.widestPlace;
  }
  if (count == 0) return;
  s.notes.push_back(
      {"half_seen",
       formatted("%zu region%s that beams saw in part, up to %.1f m2, %s neither room nor corridor",
                 count, count == 1 ? "" : "s", largest, count == 1 ? "is" : "are"),
       std::array<double, 2>{at.x, at.y}});
}

/** What was left out of the map, and why the result is empty or lacks rooms. */
void addNotes(Stages& s) {
  if (!s.cleared.clutter.empty()) s.notes.push_back(clutterNote(s.cleared.clutter));
  if (!s.result.graph.vertices().empty()) {
    noteHalfSeen(s);
    noteNarrowRegions(s);
  }
  const auto note = [&](const char* code, const char* text) {
    s.notes.push_back({code, text, std::nullopt});
  };
  if (!hasAny(s.grid, State::free))
    note("no_free_cell", "the map has no free cell, so its graph is empty");
  else if (s.obstacles.cells.empty())
    note("no_obstacle", "the map has no obstacle, so there is nothing to keep clear of");
  else if (s.result.graph.vertices().empty())
    note("no_path", "no place of the map is wide enough for a path");
  else if (s.result.rooms.empty())
    note("no_room", "the map has no room, only corridors");
}

/** Paths pass clutter on one side. */
TopologyGraph passedClutter(TopologyGraph graph, const Stages& s) {
  if (s.cleared.clutter.empty()) return graph;
  const auto isClutter = [&](Point obstacle) {
    return s.cleared.grid.atOrUnknown(s.grid.frame.cellAt(obstacle)) == State::free;
  };
  const RoomIndex rooms(s.rooms);
  const auto isInRoom = [&](Point at) { return bool(rooms.roomAt(at)); };
  ObstacleCells walls{s.obstacles.frame, {}};
  for (std::size_t i = 0; i < s.obstacles.cells.size(); ++i)
    if (!s.cleared.isClutter[i]) walls.cells.push_back(s.obstacles.cells[i]);
  return passClutter(std::move(graph), isClutter, isInRoom, ObstacleRows(walls),
                     s.options.deadEnds);
}

/** The diagram takes more memory than all else. */
enum class Diagram { isKept, isDropped };

/** All that comes behind the Voronoi diagram. */
void readDiagram(Stages& s, const StepTimer& timed, Diagram diagram) {
  const ExtractOptions& options = s.options;
  const double resolution = s.grid.frame.resolution;
  const double minLength = shortLength(options.shortDeadEnds, resolution);
  s.isInside = timed("keep_inside", keepInside, s.voronoi, s.grid, options.keepInside);

  // III-B: the rooms, which tell what is half seen
  s.cleared = timed("clear_clutter", clearClutter, s.grid, s.obstacles, options.clearClutter);
  s.outlines = outlineRegions(s, timed);
  s.rooms = s.outlines.rooms();
  s.isInside = timed("drop_half_seen", dropHalfSeen, s.voronoi, std::move(s.isInside), s.outlines);

  // III-A: the topology graph
  s.clearEdges = timed("keep_clear", keepClear, s.voronoi, s.isInside, s.clearance);
  s.topology = timed("topology_graph", topologyGraph, s.voronoi, s.clearEdges);
  if (diagram == Diagram::isDropped) s.voronoi = {}, s.isInside = {}, s.clearEdges = {};
  s.pruned = timed("dead_ends", removeDeadEnds, s.topology, options.deadEnds, resolution);
  s.pruned = timed("pass_clutter", passedClutter, std::move(s.pruned), s);
  s.joinedUp = timed("join_vertices", joinVertices, s.pruned, options.joinVertices, resolution);
  s.largest = timed("keep_largest", keepLargest, s.joinedUp, options.keepLargest, s.notes);

  // III-C to III-G: rooms in the graph
  s.stretches = timed("border_vertices", borderVertices, s.largest, s.rooms, s.clearance, kEpsilon);
  s.cut = timed("cut_paths", cutPaths, s.largest, s.stretches);
  s.cut = timed("room_ids", roomIds, std::move(s.cut), s.rooms, minLength);
  s.cleaned = timed("short_dead_ends", removeShortDeadEnds, s.cut, minLength);
  s.doors = timed("join_doors", joinDoors, s.cleaned, options.joinDoors);
  s.result = timed("room_graph", roomGraph, s.doors, s.rooms, ObstacleRows(s.obstacles),
                   s.clearance, options.roomGraph, s.notes);
  s.areas =
      timed("area_graph", areaGraph, s.cleared.grid, s.outlines, s.result, s.clearance, s.notes);
  addNotes(s);
}

/** IV-C, thinning. The flags of all cells go before the diagram needs its memory. */
ObstacleCells obstaclesOf(const Stages& s, const StepTimer& timed) {
  const auto isObstacle = timed("thin_obstacles", thinObstacles, s.grid, s.options.thinObstacles);
  return timed("obstacle_cells", obstacleCells, s.grid, isObstacle, ringIsObstacle(s));
}

/** IV-C, threshold. */
Stages binarized(const GreyMap& map, const ExtractOptions& options) {
  Stages s = prepared(map, options);
  s.grid = StepTimer(s.timings)("binarize", binarize, map, options.binarize);
  return s;
}

/** All that comes behind it. */
Stages extracted(Stages s, Diagram diagram) {
  const StepTimer timed(s.timings);
  s.obstacles = obstaclesOf(s, timed);
  // III-A: the Voronoi diagram
  s.voronoi = timed("voronoi_graph", voronoiGraph, s.obstacles);
  readDiagram(s, timed, diagram);
  return s;
}

}  // namespace

Stages extract(const GreyMap& map, const ExtractOptions& options) {
  return extracted(binarized(map, options), Diagram::isKept);
}

Stages extractGraph(GreyMap map, const ExtractOptions& options) {
  Stages s = binarized(map, options);
  map = {};
  return extracted(std::move(s), Diagram::isDropped);
}

Stages extractAgain(Stages before, const GreyMap& map, const ExtractOptions& options) {
  Stages s = prepared(map, options);
  s.grid = std::move(before.grid), s.obstacles = std::move(before.obstacles);
  s.voronoi = std::move(before.voronoi);
  readDiagram(s, StepTimer(s.timings), Diagram::isKept);
  return s;
}

}  // namespace roomgraph
