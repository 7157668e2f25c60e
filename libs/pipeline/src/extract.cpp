#include "roomgraph/pipeline/extract.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/grid/ObstacleRows.h"
#include "roomgraph/grid/wall_obstacles.h"
#include "roomgraph/rooms/RoomIndex.h"
#include "roomgraph/rooms/area_graph.h"
#include "roomgraph/rooms/cut_paths.h"
#include "roomgraph/rooms/drop_half_seen.h"
#include "roomgraph/rooms/room_ids.h"
#include "roomgraph/topology/pass_clutter.h"
#include "roomgraph/topology/topology_graph.h"
#include "roomgraph/topology/voronoi_graph.h"
#include "roomgraph/topology/voronoi_without.h"

namespace roomgraph {
namespace {

Note clutterNote(const std::vector<Clutter>& clutter) {
  const auto largest =
      std::max_element(clutter.begin(), clutter.end(),
                       [](const Clutter& a, const Clutter& b) { return a.size < b.size; });
  return {"clutter",
          formatted("%zu free-standing obstacles up to %.2f m across are taken for clutter and do "
                    "not split rooms",
                    clutter.size(), largest->size),
          std::array<double, 2>{largest->center.x, largest->center.y}};
}

/** Free width of the largest disc in an area [m]. */
double freeWidth(const Area& area, double resolution) {
  return 2 * (area.inscribedRadius - resolution / 2);
}

/** Where narrow regions outnumber the rooms, people miss them. */
void noteNarrowRegions(const Stages& s, Notes& notes) {
  const SplitAtDoorsOptions& options = s.options.splitAtDoors;
  if (s.roomRadius > 0) return;
  const auto isNarrow = [&](const Area& a) {
    const double width = freeWidth(a, s.grid.frame.resolution);
    return !a.isRoom() && width < options.openRoomWidth &&
           area(a.polygon) <= options.maxElongation * width * width;
  };
  const auto count = std::count_if(s.areas.areas.begin(), s.areas.areas.end(), isNarrow);
  if (std::size_t(count) <= s.result.rooms.size()) return;
  notes.push_back(
      {"narrow_regions",
       formatted("%td regions narrower than %.2f m are not closed by doors and count as corridor: "
                 "--set split_at_doors.open_room_width=%.2g makes rooms of them",
                 count, options.openRoomWidth, options.minRoomWidth)});
}

/** Slivers between single beams, hundreds on some maps, are not worth a word. */
void noteHalfSeen(const Stages& s, Notes& notes) {
  double largest = s.options.splitAtDoors.maxLeftoverArea;
  std::size_t count = 0;
  Point place;
  for (const Room& region : s.outlines.halfSeen()) {
    const double size = area(region.polygon);
    if (size < s.options.splitAtDoors.maxLeftoverArea) continue;
    ++count;
    if (size >= largest) largest = size, place = region.widestPlace;
  }
  if (count == 0) return;
  notes.push_back(
      {"half_seen",
       formatted("%zu region%s that beams saw in part, up to %.1f m2, %s neither room nor corridor",
                 count, count == 1 ? "" : "s", largest, count == 1 ? "is" : "are"),
       std::array<double, 2>{place.x, place.y}});
}

/** Whether free floor runs out of the map. Without unknown cells that is outside of a drawing. */
bool runsOut(const Grid& grid) {
  const auto isFreeAt = [&](int x, int y) { return grid.at({x, y}) == State::free; };
  bool isFree = false;
  for (int x = 0; x < grid.frame.width; ++x)
    isFree |= isFreeAt(x, 0) || isFreeAt(x, grid.frame.height - 1);
  for (int y = 0; y < grid.frame.height; ++y)
    isFree |= isFreeAt(0, y) || isFreeAt(grid.frame.width - 1, y);
  return isFree && !grid.has(State::unknown);
}

/** Whether there is more wall than floor, as where free and occupied are exchanged. */
bool isMostlyWall(const Grid& grid) {
  const auto count = [&](State s) { return std::count(grid.cells.begin(), grid.cells.end(), s); };
  return count(State::occupied) > count(State::free);
}

/** What was left out of the map, and why the result is empty or lacks rooms. */
Notes extractionNotes(const Stages& s) {
  Notes notes;
  const bool isEmpty = s.result.graph.vertices().empty();
  if (!s.cleared.clutter.empty()) notes.push_back(clutterNote(s.cleared.clutter));
  const bool isOpen = s.result.rooms.empty() && runsOut(s.grid);
  if (!isEmpty) noteHalfSeen(s, notes);
  if (!isEmpty && !isOpen) noteNarrowRegions(s, notes);
  const auto note = [&](const char* code, const char* text) { notes.push_back({code, text}); };
  if (!s.grid.has(State::free))
    note("no_free_cell", "the map has no free cell, so its graph is empty");
  else if (s.obstacles.cells.empty())
    note("no_obstacle", "the map has no obstacle, so there is nothing to keep clear of");
  else if (isOpen)
    note("open_edge",
         "free floor reaches the edge of the map and counts as outside: a margin of "
         "unknown cells closes it");
  else if (isEmpty)
    note("no_path", isMostlyWall(s.grid)
                        ? "no place of the map is wide enough for a path, and there is more wall "
                          "than floor: are free and occupied exchanged (negate in its yaml)?"
                        : "no place of the map is wide enough for a path");
  else if (s.result.rooms.empty())
    note("no_room", "the map has no room, only corridors");
  return notes;
}

/** Paper III-D: a cut this near to the end of a path is none [m]. */
constexpr double kEpsilon = 1e-8;

/** Of the disc that rooms are found with, no narrower than a path; 0 to split at doors [m]. */
double discRadius(const FindRoomsOptions& options, double resolution, double clearance) {
  const double radius = roomRadius(options, resolution);
  return radius > 0 ? std::max(radius, clearance) : 0;
}

/** What the steps need to know of the map and the options. */
Stages prepare(const GreyMap& map, const ExtractOptions& options) {
  Stages s;
  s.options = options;
  s.source = map.source;
  s.notes = map.notes;
  s.clearance = effectiveClearance(options.keepClear, map.frame.resolution);
  s.roomRadius = discRadius(options.findRooms, map.frame.resolution, s.clearance);
  return s;
}

/** The flags of all cells go before the diagram needs their memory. */
ObstacleCells obstaclesOf(const Stages& s) {
  // Without unknown cells a map is a drawing: beyond its border is outside, not unknown.
  const bool ringIsObstacle =
      s.options.thinObstacles.unknownIsObstacle && s.grid.has(State::unknown);
  return obstacleCells(s.grid, thinObstacles(s.grid, s.options.thinObstacles), ringIsObstacle);
}

/** III-B with one alpha, or ours. */
Regions findRegions(const VoronoiGraph& voronoi, const InsideFlags& isInside,
                    const std::vector<std::uint8_t>& isWall, const Stages& s) {
  KeepClearOptions anyPassage;
  anyPassage.minClearance = 0;
  const double resolution = s.grid.frame.resolution;
  const double minClearance = effectiveClearance(anyPassage, resolution);
  if (s.roomRadius > 0) return findRooms(voronoi, isInside, s.roomRadius, minClearance);
  return splitAtDoors(voronoi, isInside, isWall, minClearance, resolution, s.options.splitAtDoors);
}

/** On the map without clutter. Its diagram is as large as the other, and not needed for long. */
RegionOutlines outlineRegions(const Stages& s) {
  const VoronoiGraph voronoi = voronoiWithout(s.voronoi, s.obstacles, s.cleared.isClutter);
  const InsideFlags isInside = keepInside(voronoi, s.cleared.grid, s.options.keepInside);
  const std::vector<std::uint8_t> isWall = wallObstacles(s.grid, s.obstacles);
  return regionOutlines(s.cleared.grid, voronoi, isInside,
                        findRegions(voronoi, isInside, isWall, s), isWall);
}

/** Whether there are but rooms, and no path from one to the next. */
bool areClosedRooms(const RegionOutlines& outlines, double clearance) {
  return outlines.roomCount > 0 &&
         std::all_of(outlines.borders.begin(), outlines.borders.end(),
                     [&](const RegionBorder& border) { return border.clearance < clearance; });
}

/** Paths pass clutter on one side; but in a closed room they are all that there are. */
TopologyGraph passedClutter(TopologyGraph graph, const Stages& s) {
  if (areClosedRooms(s.outlines, s.clearance)) return graph;
  const auto& isOne = s.cleared.isClutter;
  if (std::find(isOne.begin(), isOne.end(), 1) == isOne.end()) return graph;
  const auto isClutter = [&](Point obstacle) {
    return s.cleared.grid.atOrUnknown(s.grid.frame.cellAt(obstacle)) == State::free;
  };
  ObstacleCells walls{s.obstacles.frame, {}};
  for (std::size_t i = 0; i < s.obstacles.cells.size(); ++i)
    if (!s.cleared.isClutter[i]) walls.cells.push_back(s.obstacles.cells[i]);
  return passClutter(std::move(graph), isClutter, ObstacleRows(walls), s.options.deadEnds);
}

/** Where the regions are is asked only if there are several components. */
TopologyGraph keptComponents(Stages& s) {
  std::optional<RoomIndex> regions;
  const auto regionAt = [&](Point place) {
    if (!regions) regions.emplace(s.outlines.worthAWay());
    return regions->roomAt(place);
  };
  return keepComponents(s.joinedUp, regionAt, s.options.keepComponents, s.notes);
}

/** Notes how long each step took that sets a member of some Stages:
 *
 *      step("voronoi_graph").voronoi = voronoiGraph(s.obstacles);
 *
 *  The right side of an assignment comes first: so the time since the last step is this one's. */
class StepTimer {
 public:
  explicit StepTimer(Stages& stages) : stages_(stages) {}

  Stages& operator()(const char* name) {
    const auto now = Clock::now();
    stages_.timings.push_back({name, std::chrono::duration<double>(now - last_).count()});
    last_ = now;
    return stages_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  Stages& stages_;
  Clock::time_point last_ = Clock::now();
};

/** The diagram takes more memory than all else. */
enum class Diagram { isKept, isDropped };

/** The paper, section by section. `cells` gives the map as Grid; without it, grid, obstacles and
 *  diagram are there already. */
Stages extractGrid(Stages s, const std::function<Grid()>& cells, Diagram diagram) {
  const ExtractOptions& options = s.options;
  StepTimer step(s);
  if (cells) {
    // IV-C: threshold and thinning
    step("binarize").grid = cells();
    step("obstacle_cells").obstacles = obstaclesOf(s);
    // III-A: the Voronoi diagram
    step("voronoi_graph").voronoi = voronoiGraph(s.obstacles);
  }
  const double resolution = s.grid.frame.resolution;
  step("keep_inside").isInside = keepInside(s.voronoi, s.grid, options.keepInside);
  // Ours: regions without clutter, and what no beam has seen whole
  step("clear_clutter").cleared = clearClutter(s.grid, s.obstacles, options.clearClutter);
  step("region_outlines").outlines = outlineRegions(s);
  // III-A: the topology graph
  step("keep_clear").clearEdges = keepClear(s.voronoi, s.isInside, s.clearance);
  step("drop_half_seen").clearEdges = dropHalfSeen(s.voronoi, std::move(s.clearEdges), s.outlines);
  step("topology_graph").topology = topologyGraph(s.voronoi, s.clearEdges);
  if (diagram == Diagram::isDropped) s.voronoi = {}, s.isInside = {}, s.clearEdges = {};
  step("dead_ends").pruned = removeDeadEnds(s.topology, options.deadEnds, resolution);
  step("pass_clutter").pruned = passedClutter(std::move(s.pruned), s);
  step("join_vertices").joinedUp = joinVertices(s.pruned, options.joinVertices, resolution);
  step("keep_components").kept = keptComponents(s);
  // III-B: the rooms
  step("trace_rooms").rooms = s.outlines.rooms();
  // III-C to III-G: rooms in the graph
  const double minLength = shortLength(options.shortDeadEnds, resolution);
  step("border_vertices").stretches = borderVertices(s.kept, s.rooms, s.clearance, kEpsilon);
  step("cut_paths").cut = cutPaths(s.kept, s.stretches);
  step("room_ids").cut = roomIds(std::move(s.cut), s.rooms, minLength);
  step("short_dead_ends").cleaned = removeShortDeadEnds(s.cut, minLength);
  // Rooms that are split at their doors share these; those of a disc leave a gap in each.
  step("join_doors").doors = s.roomRadius > 0 ? joinDoors(s.cleaned, options.joinDoors) : s.cleaned;
  step("room_graph").result = roomGraph(s.doors, s.rooms, ObstacleRows(s.obstacles), s.clearance,
                                        options.roomGraph, s.notes);
  step("area_graph").areas =
      areaGraph(s.cleared.grid, s.outlines, s.result, s.clearance, options.splitAtDoors, s.notes);
  for (Note& note : extractionNotes(s)) s.notes.push_back(std::move(note));
  return s;
}

}  // namespace

Stages extract(const GreyMap& map, const ExtractOptions& options) {
  const auto cells = [&] { return binarize(map, options.binarize); };
  return extractGrid(prepare(map, options), cells, Diagram::isKept);
}

Stages extractGraph(GreyMap map, const ExtractOptions& options) {
  const auto cells = [&] {
    Grid grid = binarize(map, options.binarize);
    map = {};
    return grid;
  };
  return extractGrid(prepare(map, options), cells, Diagram::isDropped);
}

Stages extractAgain(Stages before, const GreyMap& map, const ExtractOptions& options) {
  Stages s = prepare(map, options);
  s.grid = std::move(before.grid), s.obstacles = std::move(before.obstacles);
  s.voronoi = std::move(before.voronoi);
  return extractGrid(std::move(s), nullptr, Diagram::isKept);
}

}  // namespace roomgraph
