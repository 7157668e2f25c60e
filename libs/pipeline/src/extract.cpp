#include "roomgraph/pipeline/extract.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include "extraction_notes.h"
#include "roomgraph/base/sequences.h"
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
                    const std::vector<std::uint8_t>& isWall, const Grid& grid, const Stages& s) {
  KeepClearOptions anyPassage;
  anyPassage.minClearance = 0;
  const double resolution = grid.frame.resolution;
  const double minClearance = effectiveClearance(anyPassage, resolution);
  if (s.roomRadius > 0) return findRooms(voronoi, isInside, s.roomRadius, minClearance);
  return splitAtDoors(voronoi, isInside, isWall, minClearance, grid, s.options.splitAtDoors);
}

/** On an open map, without clutter and furniture. Its diagram is as large as the other, and not
 *  needed for long. */
RegionOutlines outlineRegions(const Stages& s, const ClearedMap& open) {
  const VoronoiGraph voronoi = voronoiWithout(s.voronoi, s.obstacles, open.isClutter);
  const InsideFlags isInside = keepInside(voronoi, open.grid, s.options.keepInside);
  const std::vector<std::uint8_t> isWall = wallObstacles(s.grid, s.obstacles);
  return regionOutlines(open.grid, voronoi, isInside,
                        findRegions(voronoi, isInside, isWall, open.grid, s), isWall);
}

/** A map without furniture is open already, and not copied. */
RegionOutlines outlineRegions(const Stages& s) {
  return s.cleared.furniture.empty() ? outlineRegions(s, s.cleared)
                                     : outlineRegions(s, withoutFurniture(s.cleared, s.obstacles));
}

/** Whether there are but rooms, and no path from one to the next. */
bool areClosedRooms(const RegionOutlines& outlines, double clearance) {
  return outlines.roomCount > 0 && allOf(outlines.borders, [&](const RegionBorder& border) {
           return border.clearance < clearance;
         });
}

/** Paths pass clutter on one side; but in a closed room they are all that there are. */
TopologyGraph passedClutter(TopologyGraph graph, const Stages& s, const LeadsOn& leadsOn) {
  if (areClosedRooms(s.outlines, s.clearance)) return graph;
  const auto& isOne = s.cleared.isClutter;
  if (std::find(isOne.begin(), isOne.end(), 1) == isOne.end()) return graph;
  const auto isClutter = [&](Point obstacle) {
    return s.cleared.grid.atOrUnknown(s.grid.frame.cellAt(obstacle)) == State::free;
  };
  ObstacleCells walls{s.obstacles.frame, {}};
  for (std::size_t i = 0; i < s.obstacles.cells.size(); ++i)
    if (!s.cleared.isClutter[i]) walls.cells.push_back(s.obstacles.cells[i]);
  return passClutter(std::move(graph), isClutter, ObstacleRows(walls), s.options.deadEnds, leadsOn);
}

/** The regions that are worth a way, found when they are asked for. */
class WorthyRegions {
 public:
  explicit WorthyRegions(const RegionOutlines& outlines) : outlines_(outlines) {}

  /** As the steps ask for them. */
  LeadsOn leadsOn() {
    return [this](const Vertex& tip, const Vertex& base) { return isMiddle(tip, base); };
  }
  RegionAt regionAt() {
    return [this](Point place) { return at(place); };
  }

 private:
  RoomId at(Point place) {
    if (!index_) regions_ = outlines_.worthAWay(), index_.emplace(regions_);
    return index_->roomAt(place);
  }

  /** Whether the tip is the middle of a region that the base is not in. */
  bool isMiddle(const Vertex& tip, const Vertex& base) {
    const RoomId region = at(tip.place);
    return region && region != at(base.place) &&
           distance(tip.place, regions_[region.index()].widestPlace) <= tip.clearance;
  }

  const RegionOutlines& outlines_;
  Rooms regions_;
  std::optional<RoomIndex> index_;
};

TopologyGraph keptComponents(Stages& s, const RegionAt& regionAt) {
  return keepComponents(s.joinedUp, regionAt, s.options.keepComponents, s.notes);
}

RoomGraph roomGraphOf(Stages& s) {
  return roomGraph(s.doors, s.rooms, ObstacleRows(s.obstacles), s.clearance, s.options.roomGraph,
                   s.notes);
}

AreaGraph areasOf(Stages& s) {
  return areaGraph(s.cleared.grid, s.outlines, s.result, s.clearance, s.options.splitAtDoors,
                   s.notes);
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
  WorthyRegions regions(s.outlines);
  const LeadsOn leadsOn = regions.leadsOn();
  // III-A: the topology graph
  step("keep_clear").clearEdges = keepClear(s.voronoi, s.isInside, s.clearance);
  step("drop_half_seen").clearEdges = dropHalfSeen(s.voronoi, std::move(s.clearEdges), s.outlines);
  step("topology_graph").topology = topologyGraph(s.voronoi, s.clearEdges);
  if (diagram == Diagram::isDropped) s.voronoi = {}, s.isInside = {}, s.clearEdges = {};
  step("dead_ends").pruned = removeDeadEnds(s.topology, options.deadEnds, resolution, leadsOn);
  step("pass_clutter").pruned = passedClutter(std::move(s.pruned), s, leadsOn);
  step("join_vertices").joinedUp = joinVertices(s.pruned, options.joinVertices, resolution);
  step("keep_components").kept = keptComponents(s, regions.regionAt());
  // III-B: the rooms
  step("trace_rooms").rooms = s.outlines.rooms();
  // III-C to III-G: rooms in the graph
  step("border_vertices").stretches = borderVertices(s.kept, s.rooms, s.clearance, kEpsilon);
  step("cut_paths").cut = cutPaths(s.kept, s.stretches);
  step("room_ids").cut = roomIds(std::move(s.cut), s.rooms);
  const double minLength = shortLength(options.shortDeadEnds, resolution);
  step("short_dead_ends").cleaned = removeShortDeadEnds(s.cut, minLength);
  // Rooms that are split at their doors share these; those of a disc leave a gap in each.
  step("join_doors").doors = s.roomRadius > 0 ? joinDoors(s.cleaned, options.joinDoors) : s.cleaned;
  step("room_graph").result = roomGraphOf(s);
  step("area_graph").areas = areasOf(s);
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
