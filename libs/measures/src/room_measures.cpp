#include "room_measures.h"

#include <utility>

#include "roomgraph/measures/match_elements.h"
#include "run_measures.h"

namespace roomgraph {
namespace {

std::vector<GraphRoom> roomsInSite(const Run& run, const Transform2D& pose) {
  std::vector<GraphRoom> rooms = run.rooms;
  for (GraphRoom& room : rooms) {
    room.center = pose(room.center);
    room.shape.polygon = movedBy(std::move(room.shape.polygon), pose);
  }
  return rooms;
}

RoomCount countRooms(const std::vector<GraphRoom>& others, const std::vector<bool>& isMatched,
                     const WallMap& map, const Transform2D& back) {
  RoomCount count;
  for (std::size_t r = 0; r < others.size(); ++r) {
    if (isMatched[r]) ++count.matched;
    if (isMatched[r] || isFreeIn(map, back(others[r].center))) ++count.visible;
    const double size = area(others[r].shape.polygon);
    count.area += size;
    if (isMatched[r]) count.matchedArea += size;
  }
  return count;
}

/** The share `part` of `all` in the rooms of the others. */
MeasuredValue shareOf(const RoomCounts& counts, const Trust& trust, std::size_t run,
                      double RoomCount::*part, double RoomCount::*all) {
  std::vector<ShareInOther> others;
  for (const std::size_t j : counts.othersOf(run)) {
    const RoomCount& count = counts(run, j);
    others.push_back(
        {trust[j] > 0 ? count.*all : 0, trust[j] * count.*part, trust[j] * count.*all});
  }
  return shareOverOthers(others);
}

}  // namespace

RoomCounts roomCounts(const Site& site, const std::vector<PairOfThings>& pairs,
                      const ForEach& forEach) {
  const GridFrame frame = siteFrame(site);
  const std::size_t n = site.runs.size();
  std::vector<std::vector<GraphRoom>> rooms;
  for (std::size_t i = 0; i < n; ++i) rooms.push_back(roomsInSite(*site.runs[i], site.poses[i]));
  RoomCounts counts(n, pairs);
  forEach(pairs.size(), [&](std::size_t k) {
    const auto [i, j] = pairs[k];
    std::vector<bool> ofI(rooms[i].size()), ofJ(rooms[j].size());
    for (const MatchedRooms& match : matchRooms(rooms[i], rooms[j], frame)) {
      ofI[match.base.index()] = true;
      ofJ[match.other.index()] = true;
    }
    counts(i, j) = countRooms(rooms[j], ofJ, site.runs[i]->map, site.poses[i].inverse());
    counts(j, i) = countRooms(rooms[i], ofI, site.runs[j]->map, site.poses[j].inverse());
  });
  return counts;
}

MeasuredValue roomsMatchedOf(const RoomCounts& counts, const Trust& trust, std::size_t run) {
  return shareOf(counts, trust, run, &RoomCount::matched, &RoomCount::visible);
}

MeasuredValue roomCoverageOf(const RoomCounts& counts, const Trust& trust, std::size_t run) {
  return shareOf(counts, trust, run, &RoomCount::matchedArea, &RoomCount::area);
}

}  // namespace roomgraph
