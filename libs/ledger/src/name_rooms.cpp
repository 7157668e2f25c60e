#include "roomgraph/ledger/name_rooms.h"

#include <algorithm>
#include <map>
#include <utility>

#include "match_areas.h"
#include "roomgraph/align/align_maps.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/OneToOne.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/grid/polygon_cells.h"
#include "roomgraph/ledger/site_rooms.h"

namespace roomgraph {
namespace {

/** Any id will do: the areas get new ones. */
std::string idOf(AreaId area) { return std::to_string(area.index()); }

std::vector<SiteRoom> roomsOf(const AreaGraph& graph) {
  std::vector<SiteRoom> rooms;
  for (std::size_t a = 0; a < graph.areas.size(); ++a) {
    const Area& area = graph.areas[a];
    SiteRoom& room = rooms.emplace_back();
    room.id = idOf(AreaId(a)), room.isCorridor = !area.isRoom();
    room.center = area.widestPlace, room.polygon = area.polygon;
    room.area = roomgraph::area(area.polygon);
    for (const PassageId p : area.passages) {
      const Passage& passage = graph.passages[p.index()];
      if (!passage.b) continue;
      const AreaId to = passage.a == AreaId(a) ? passage.b : passage.a;
      room.doors.push_back({passage.middle(), passage.width, idOf(to)});
    }
    room.runs.emplace_back().run = room.id;
  }
  return rooms;
}

SiteRoom moved(SiteRoom room, const Transform2D& pose) {
  const Motion2D motion(pose);
  room.center = motion(room.center);
  room.polygon = movedBy(std::move(room.polygon), motion);
  for (SiteDoor& door : room.doors) door.place = motion(door.place);
  return room;
}

/** Rooms and their doors as areas with passages. */
AreaGraph areasOf(const std::vector<SiteRoom>& rooms) {
  AreaGraph graph;
  std::map<std::string, std::size_t> placeOf;
  for (const SiteRoom& room : rooms) {
    placeOf[room.id] = graph.areas.size();
    Area area;
    if (!room.isCorridor) area.room = RoomId(graph.areas.size());
    area.polygon = room.polygon;
    graph.areas.push_back(area);
  }
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (const SiteDoor& door : rooms[r].doors)
      if (const auto to = placeOf.find(door.to); to != placeOf.end())
        graph.passages.push_back(
            {AreaId(r), AreaId(to->second), door.place, door.place, door.width});
  return graph;
}

std::vector<const Polygon*> polygonsOf(const std::vector<SiteRoom>& rooms) {
  return mapped(rooms, [](const SiteRoom& room) { return &room.polygon; });
}

void drawWall(Point a, Point b, Grid& grid) {
  const int steps = 1 + int(2 * distance(a, b) / grid.frame.resolution);
  for (int k = 0; k <= steps; ++k) {
    const Cell c = grid.frame.cellAt(a + (double(k) / steps) * (b - a));
    if (grid.frame.contains(c)) grid.cells[grid.frame.index(c)] = State::occupied;
  }
}

void drawDoor(const SiteDoor& door, Grid& grid) {
  const double radius = std::min(door.width / 2, 2.0);
  const Cell low = grid.frame.cellAt(door.place - Point{radius, radius});
  const Cell high = grid.frame.cellAt(door.place + Point{radius, radius});
  for (int y = std::max(0, low.y); y <= std::min(grid.frame.height - 1, high.y); ++y)
    for (int x = std::max(0, low.x); x <= std::min(grid.frame.width - 1, high.x); ++x)
      if (distance(grid.frame.center({x, y}), door.place) < radius)
        grid.cells[grid.frame.index({x, y})] = State::free;
}

/** A map of the rooms: free inside, walls along the outlines, but in the doors. */
WallMap mapOf(const std::vector<SiteRoom>& rooms) {
  GridFrame frame = frameRound(polygonsOf(rooms));
  frame.resolution /= 2;
  frame.width = 2 * frame.width + 1, frame.height = 2 * frame.height + 1;
  Grid grid{frame, std::vector<State>(frame.cellCount(), State::unknown)};
  for (const SiteRoom& room : rooms)
    for (const Cell c : cellsIn(room.polygon, frame)) grid.cells[frame.index(c)] = State::free;
  for (const SiteRoom& room : rooms)
    forEachEdge(room.polygon, [&](Point a, Point b) { drawWall(a, b, grid); });
  for (const SiteRoom& room : rooms)
    for (const SiteDoor& door : room.doors) drawDoor(door, grid);
  return wallMap(grid);
}

/** Which known room each room is, and how well it fits. */
struct Found {
  std::vector<AreaMatch> matches;
  double area = 0;  ///< of the rooms that are found in their places, as a share of the smaller site
};

Found findRooms(const std::vector<SiteRoom>& rooms, const SiteFile& file, const Transform2D& pose) {
  const auto inFile = mapped(rooms, [&](const SiteRoom& room) { return moved(room, pose); });
  std::vector<const Polygon*> polygons = polygonsOf(inFile);
  for (const Polygon* polygon : polygonsOf(file.rooms)) polygons.push_back(polygon);
  const GridFrame frame = frameRound(polygons);
  const RunAreas now = areasIn(areasOf(inFile), frame), known = areasIn(areasOf(file.rooms), frame);
  RoomSet set{now.shapes, {}};
  for (const auto& doors : now.doors) {
    std::vector<std::size_t> neighbours = mapped(doors, &AreaDoor::to);
    sortUnique(neighbours);
    set.neighbours.push_back(std::move(neighbours));
  }
  RoomFits fits;
  addFits(set.shapes, frame, known, fits);
  Found found{matchAreas(set, fits, frame, known), 0};
  double all = 0, before = 0, inPlace = 0;
  for (const SiteShape& shape : known.shapes) before += shape.area;
  for (std::size_t s = 0; s < set.shapes.size(); ++s) {
    const AreaMatch& match = found.matches[s];
    all += set.shapes[s].area;
    if (match.isMatched() && match.overlap > 0.5 && norm(match.move.shift) < kNearSearch.reach)
      inPlace += set.shapes[s].area;
  }
  found.area = inPlace / std::max(1e-9, std::min(all, before));
  return found;
}

/** A number that no id of the file has, and counts on. */
std::string newId(SiteFile& file, bool isCorridor) {
  int& next = isCorridor ? file.nextCorridor : file.nextRoom;
  for (;;) {
    std::string id = (isCorridor ? "C" : "R") + std::to_string(next++);
    if (!anyOf(file.rooms, [&](const SiteRoom& room) { return room.id == id; })) return id;
  }
}

/** The known room of each room, each once, those that overlap most first. */
std::vector<std::optional<std::size_t>> knownRooms(const std::vector<AreaMatch>& matches,
                                                   std::size_t known) {
  std::vector<std::pair<double, std::size_t>> order;  // -overlap, room
  for (std::size_t s = 0; s < matches.size(); ++s)
    if (matches[s].isMatched()) order.emplace_back(-matches[s].overlap, s);
  std::sort(order.begin(), order.end());
  std::vector<std::optional<std::size_t>> result(matches.size());
  OneToOne pairing(matches.size(), known);
  for (const auto& [overlap, s] : order)
    if (const std::size_t area = matches[s].areas[0]; pairing.take(s, area)) result[s] = area;
  return result;
}

/** A known room as it is drawn now. */
SiteRoom reshaped(const SiteRoom& known, const SiteRoom& room, const Transform2D& pose) {
  SiteRoom now = moved(room, pose);
  now.id = known.id, now.name = known.name, now.isCorridor = known.isCorridor;
  now.runs.clear();
  return now;
}

void sortKnown(std::vector<SiteRoom>& rooms) { sortBy(rooms, &SiteRoom::isCorridor); }

}  // namespace

NamedAreas nameAreas(const AreaGraph& areas, SiteFile file, const std::string& name) {
  NamedRooms named = nameRooms(roomsOf(areas), std::move(file), name);
  std::map<std::string, int> uses;
  for (const SiteRoom& room : named.rooms) ++uses[room.name];
  NamedAreas result{std::vector<std::string>(areas.areas.size()), std::move(named.file)};
  for (const SiteRoom& room : named.rooms)  // what a room was before, its only run tells
    result.names[std::stoul(room.runs.front().run)] =
        uses[room.name] > 1 && room.name != room.id ? room.name + " (" + room.id + ")" : room.name;
  return result;
}

NamedRooms nameRooms(std::vector<SiteRoom> rooms, SiteFile file, const std::string& name) {
  if (rooms.empty()) return {{}, std::move(file)};
  Transform2D pose;  // file <- site
  Found found = findRooms(rooms, file, pose);
  if (!file.rooms.empty() && found.area < kMajority) {
    const Alignment alignment = alignMaps(mapOf(file.rooms), mapOf(rooms));
    pose = alignment.pose;
    const bool isSure = !alignment.isAmbiguous && alignment.confidence >= kMajority;
    if (alignment.isSameSite && isSure) found = findRooms(rooms, file, pose);
    if (found.area < kMajority)
      throw DataError(name +
                      ": its rooms cannot be found in these runs, or in several ways: name "
                      "the file of this site, or one that is not there yet");
  }
  const auto knownOf = knownRooms(found.matches, file.rooms.size());
  std::map<std::string, std::string> newIdOf;
  std::vector<std::size_t> placeOf;  // in the file
  for (std::size_t s = 0; s < rooms.size(); ++s) {
    if (!knownOf[s]) {
      const std::string id = newId(file, rooms[s].isCorridor);
      SiteRoom& known = file.rooms.emplace_back();
      known.id = known.name = id, known.isCorridor = rooms[s].isCorridor;
    }
    placeOf.push_back(knownOf[s].value_or(file.rooms.size() - 1));
    newIdOf[rooms[s].id] = file.rooms[placeOf[s]].id;
  }
  for (std::size_t s = 0; s < rooms.size(); ++s) {
    SiteRoom& room = rooms[s];
    SiteRoom& known = file.rooms[placeOf[s]];
    room.id = known.id, room.name = known.name;
    for (SiteDoor& door : room.doors)
      if (!door.to.empty()) door.to = newIdOf.at(door.to);
    if (!knownOf[s] || found.matches[s].overlap < kMajority) known = reshaped(known, room, pose);
  }
  sortKnown(file.rooms);
  sortRooms(rooms);
  return {std::move(rooms), std::move(file)};
}

}  // namespace roomgraph
