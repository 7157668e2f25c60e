#include "room_doors.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fit_shape.h"
#include "fitted_ledger.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/OneToOne.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** A door, and by run: who has it, who knows all round its place, and who has a wall across it. */
struct Group {
  RoomDoors::Door door;
  std::vector<bool> isIn, isKnown{}, isBarred{};
};

/** Whether a run knows all round a place, as far as maps bend. */
bool knows(const RunAreas& run, const GridFrame& frame, Point p) {
  const double near = kSameWhereBent;
  for (const Point by : {Point{0, 0}, {near, 0}, {-near, 0}, {0, near}, {0, -near}}) {
    const std::size_t cell = cellIndexAt(frame, p + by);
    if (cell >= run.labels.size() || run.labels[cell] == RunAreas::unknown) return false;
  }
  return true;
}

/** Whether no cell of the line is wall. */
bool isClear(const RunAreas& run, const GridFrame& frame, Point from, Point to) {
  const int steps = int(std::ceil(2 * distance(from, to) / frame.resolution));
  for (int i = 0; i <= steps; ++i) {
    const std::size_t cell = cellIndexAt(frame, from + (double(i) / steps) * (to - from));
    if (cell < run.isWall.size() && run.isWall[cell]) return false;
  }
  return true;
}

/** Whether no straight way leads across an opening, within its width or so far beside it [m]. */
bool isBarred(const RunAreas& run, const GridFrame& frame, Point from, Point end, double beside) {
  const Point along = (1 / distance(from, end)) * (end - from);
  const Point across = kSameWhereBent * Point{-along.y, along.x};
  const Point first = from - beside * along, last = end + beside * along;
  const int ways = int(std::ceil(2 * distance(first, last) / frame.resolution));
  for (int i = 0; i <= ways; ++i) {
    const Point at = first + (double(i) / ways) * (last - first);
    if (isClear(run, frame, at - across, at + across)) return false;
  }
  return true;
}

std::optional<std::size_t> roomOf(const std::vector<AreaMatch>& matches, std::size_t area) {
  for (std::size_t s = 0; s < matches.size(); ++s)
    if (contains(matches[s].areas, area)) return s;
  return std::nullopt;
}

/** Where the surroundings of a door lie in a run: those of the smaller of its two rooms, since
 *  a long corridor may bend. */
Transform2D moveAt(const RoomSet& rooms, const RoomsInRun& in, std::size_t room,
                   std::optional<std::size_t> to) {
  const bool isBehind = to && in.isClean[*to] && rooms.shapes[*to].area < rooms.shapes[room].area;
  const std::size_t guide = isBehind ? *to : room;
  return in.moves[guide].about(rooms.shapes[guide].middle);
}

/** The doors of a room in a run, where the room's shape lies, but those between its pieces. */
std::vector<RoomDoors::Door> doorsIn(const RunAreas& run, const ConsensusRooms& consensus,
                                     const std::vector<AreaMatch>& matches, std::size_t room,
                                     const RoomsInRun& in) {
  const std::vector<std::size_t>& areas = matches[room].areas;
  std::vector<RoomDoors::Door> doors;
  for (const std::size_t area : areas)
    for (const AreaDoor& door : run.doors[area]) {
      if (contains(areas, door.to)) continue;
      const std::optional<std::size_t> to = roomOf(matches, door.to);
      const Transform2D back = moveAt(consensus.rooms, in, room, to).inverse();
      doors.push_back({back(door.from), back(door.end), to});
    }
  return doors;
}

/** Counts the doors of a run to the nearest groups, one each, nearest first. */
void join(const std::vector<RoomDoors::Door>& doors, std::size_t run, std::size_t runs,
          std::vector<Group>& groups) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> offers;  // distance, door, group
  for (std::size_t d = 0; d < doors.size(); ++d)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const double far = distance(doors[d].place(), groups[g].door.place());
      const bool isSameTo = doors[d].to && doors[d].to == groups[g].door.to;
      if (far <= (isSameTo ? kWideSearch.reach : fitted::kSameDoor)) offers.emplace_back(far, d, g);
    }
  std::sort(offers.begin(), offers.end());
  OneToOne pairing(doors.size(), groups.size());
  for (const auto& [far, d, g] : offers) {
    if (!pairing.take(d, g)) continue;
    groups[g].isIn[run] = true;
    if (!groups[g].door.to) groups[g].door.to = doors[d].to;
  }
  for (std::size_t d = 0; d < doors.size(); ++d) {
    if (pairing.hasFirst(d)) continue;
    groups.push_back({doors[d], std::vector<bool>(runs)});
    groups.back().isIn[run] = true;
  }
}

/** All doors of the room in all runs; that of the room's own drawing gives the places. */
std::vector<Group> groupsOf(const SiteAreas& site, const ConsensusRooms& consensus,
                            std::size_t room, const std::vector<RoomsInRun>& inRuns) {
  const std::size_t n = site.runs.size();
  std::vector<std::size_t> order{consensus.sources[room].run};
  for (std::size_t i = 0; i < n; ++i)
    if (i != order[0]) order.push_back(i);
  std::vector<Group> groups;
  for (const std::size_t i : order)
    if (inRuns[i].isClean[room])
      join(doorsIn(site.runs[i], consensus, consensus.matches[i], room, inRuns[i]), i, n, groups);
  return groups;
}

/** What the runs that do not have the door say of its place. */
void askOthers(Group& group, const SiteAreas& site, const ConsensusRooms& consensus,
               std::size_t room, const std::vector<RoomsInRun>& inRuns) {
  group.isKnown = group.isIn;
  group.isBarred.resize(group.isIn.size());
  for (std::size_t i = 0; i < group.isIn.size(); ++i) {
    if (!inRuns[i].isClean[room] || group.isIn[i]) continue;
    const Transform2D move = moveAt(consensus.rooms, inRuns[i], room, group.door.to);
    const Point from = move(group.door.from), end = move(group.door.end);
    group.isKnown[i] = knows(site.runs[i], site.frame, midpoint(from, end));
    // Seen from one side, as a door that is shut, it may only have been drawn elsewhere.
    const double beside = group.isKnown[i] ? kSameWhereBent : kWideSearch.reach;
    group.isBarred[i] = isBarred(site.runs[i], site.frame, from, end, beside);
  }
}

/** Of the runs that are counted. */
template <class IsCounted>
double weightOf(const SiteAreas& site, const IsCounted& isCounted) {
  double sum = 0;
  for (std::size_t i = 0; i < site.runs.size(); ++i)
    if (isCounted(i)) sum += site.runs[i].weight;
  return sum;
}

}  // namespace

RoomDoors roomDoors(const SiteAreas& site, const ConsensusRooms& consensus, std::size_t room,
                    const std::vector<RoomsInRun>& inRuns) {
  const std::size_t n = site.runs.size();
  RoomDoors result;
  result.gained.assign(n, 0), result.lost.assign(n, 0);
  for (Group& group : groupsOf(site, consensus, room, inRuns)) {
    askOthers(group, site, consensus, room, inRuns);
    const double half = 0.5 * weightOf(site, [&](std::size_t i) { return group.isKnown[i]; });
    const bool isDoor = weightOf(site, [&](std::size_t i) { return group.isIn[i]; }) > half;
    const bool isWall = weightOf(site, [&](std::size_t i) {
                          return group.isKnown[i] && group.isBarred[i];
                        }) >= half;
    RoomDoors::Door door = group.door;
    for (std::size_t i = 0; i < n; ++i) {
      if (isWall && group.isIn[i]) ++result.gained[i];
      if (isDoor && group.isIn[i]) door.seenIn.push_back(i);
      if (isDoor && group.isBarred[i]) ++result.lost[i], door.lostIn.push_back(i);
    }
    if (isDoor) result.doors.push_back(std::move(door));
  }
  return result;
}

}  // namespace roomgraph
