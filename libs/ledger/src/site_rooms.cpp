#include "roomgraph/ledger/site_rooms.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "consensus_rooms.h"
#include "fitted_ledger.h"
#include "room_doors.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

/** Whether a run has all of a room, as one area that is no other room's, too. */
bool isClean(const AreaMatch& match) {
  return match.areas.size() == 1 && !match.isMerged && match.overlap >= kMinOverlap &&
         match.known >= fitted::kComplete;
}

/** Of each room the runs whose outlines the others are held against: the most trusted ones that
 *  have it clean. */
std::vector<std::vector<std::size_t>> judgesOf(const SiteAreas& site,
                                               const ConsensusRooms& consensus) {
  std::vector<std::vector<std::size_t>> judges(consensus.rooms.shapes.size());
  for (std::size_t room = 0; room < judges.size(); ++room) {
    for (std::size_t i = 0; i < site.runs.size(); ++i)
      if (isClean(consensus.matches[i][room])) judges[room].push_back(i);
    sortDownBy(judges[room], [&](std::size_t i) { return site.runs[i].weight; });
    if (judges[room].size() > kMaxVoters) judges[room].resize(kMaxVoters);
  }
  return judges;
}

std::vector<RoomsInRun> roomsInRuns(const SiteAreas& site, const ConsensusRooms& consensus,
                                    const std::vector<std::vector<std::size_t>>& judges,
                                    const ForEach& forEach) {
  const auto outlines = mapped(consensus.rooms.shapes,
                               [](const SiteShape& shape) { return RoomOutline(shape.polygon); });
  std::vector<RoomsInRun> runs(site.runs.size());
  forEach(runs.size(), [&](std::size_t i) {
    for (std::size_t s = 0; s < outlines.size(); ++s) {
      const AreaMatch& match = consensus.matches[i][s];
      runs[i].isClean.push_back(isClean(match));
      runs[i].moves.push_back(match.move);
      if (!isClean(match)) continue;
      RoomOutline outline(site.runs[i].shapes[match.areas[0]].polygon);
      runs[i].moves[s] =
          refinedMove(outlines[s], outline, match.move, consensus.rooms.shapes[s].middle);
      if (contains(judges[s], i)) runs[i].outlines.emplace(s, std::move(outline));
    }
  });
  return runs;
}

/** One room of the site and its figures. */
class Ledger {
 public:
  Ledger(const SiteAreas& site, const ConsensusRooms& consensus,
         const std::vector<std::size_t>& judges, const std::vector<RoomsInRun>& runs,
         const RoomDoors& doors, std::size_t room)
      : site_(site),
        consensus_(consensus),
        judges_(judges),
        inRuns_(runs),
        doors_(doors),
        room_(room),
        shape_(consensus.rooms.shapes[room]) {}

  SiteRoom room() const {
    SiteRoom result;
    result.polygon = simplified(shape_.polygon, kWallCell / 2);
    result.center = shape_.middle;
    result.isCorridor = isCorridor();
    result.area = areaMedian();
    for (std::size_t i = 0; i < site_.runs.size(); ++i) result.runs.push_back(inRun(i));
    addShifts(result);
    addLengths(result);
    return result;
  }

 private:
  const AreaMatch& matchIn(std::size_t run) const { return consensus_.matches[run][room_]; }
  bool isCleanIn(std::size_t run) const { return inRuns_[run].isClean[room_]; }
  const RoomMove& moveIn(std::size_t run) const { return inRuns_[run].moves[room_]; }

  bool isCorridor() const {
    double corridor = 0, all = 0;
    for (std::size_t i = 0; i < site_.runs.size(); ++i) {
      if (!isCleanIn(i)) continue;
      all += site_.runs[i].weight;
      if (site_.runs[i].shapes[matchIn(i).areas[0]].isCorridor) corridor += site_.runs[i].weight;
    }
    return all > 0 ? corridor > 0.5 * all : shape_.isCorridor;
  }

  /** Of all pieces; none where it is another room's, too, or seen in part. */
  std::optional<double> areaIn(std::size_t run) const {
    const AreaMatch& match = matchIn(run);
    if (!match.isMatched() || match.isMerged || match.known < fitted::kComplete)
      return std::nullopt;
    double sum = 0;
    for (const std::size_t area : match.areas) sum += site_.runs[run].shapes[area].area;
    return sum;
  }

  double areaMedian() const {
    std::vector<WeightedValue> areas;
    for (std::size_t i = 0; i < site_.runs.size(); ++i)
      if (const auto area = areaIn(i)) areas.push_back({*area, site_.runs[i].weight});
    return weightedMedian(std::move(areas)).value_or(shape_.area);
  }

  RoomInRun inRun(std::size_t run) const {
    const AreaMatch& match = matchIn(run);
    RoomInRun result;
    if (match.isMatched())
      result.sighting = RoomSighting::seen;
    else if (match.known >= kMajority)
      result.sighting =
          match.free > kMajority * match.known ? RoomSighting::seen : RoomSighting::gone;
    result.pieces = int(match.areas.size());
    result.isMerged = match.isMerged;
    if (const auto area = areaIn(run)) result.areaChange = *area / areaMedian() - 1;
    result.boundaryAgreement = agreementOf(run);
    result.doorsGained = doors_.gained[run], result.doorsLost = doors_.lost[run];
    return result;
  }

  /** Mean over the other runs, the most trusted ones, by weight. */
  std::optional<double> agreementOf(std::size_t run) const {
    if (!isCleanIn(run)) return std::nullopt;
    const RoomOutline own(site_.runs[run].shapes[matchIn(run).areas[0]].polygon);
    double sum = 0, all = 0;
    for (const std::size_t j : judges_) {
      if (j == run) continue;
      const Transform2D between =
          moveIn(j).about(shape_.middle) * moveIn(run).about(shape_.middle).inverse();
      const double weight = site_.runs[j].weight;
      sum += weight * outlineAgreement(own, inRuns_[j].outlines.at(room_), between, kSameWall);
      all += weight;
    }
    return all > 0 ? std::optional(sum / all) : std::nullopt;
  }

  void addShifts(SiteRoom& result) const {
    std::vector<WeightedValue> xs, ys;
    for (std::size_t i = 0; i < site_.runs.size(); ++i) {
      if (!isCleanIn(i)) continue;
      xs.push_back({moveIn(i).shift.x, site_.runs[i].weight});
      ys.push_back({moveIn(i).shift.y, site_.runs[i].weight});
    }
    if (xs.size() < 2) return;
    const Point consensus{*weightedMedian(xs), *weightedMedian(ys)};
    for (std::size_t i = 0; i < site_.runs.size(); ++i)
      if (isCleanIn(i) && result.runs[i].boundaryAgreement.value_or(0) >= fitted::kMinAgreement) {
        const SiteShape& own = site_.runs[i].shapes[matchIn(i).areas[0]];
        result.runs[i].shift = distance(moveIn(i).shift + own.drawn - own.middle, consensus);
      }
  }

  void addLengths(SiteRoom& result) const {
    if (!result.isCorridor) return;
    std::vector<double> lengths(site_.runs.size());
    std::vector<WeightedValue> all;
    for (std::size_t i = 0; i < site_.runs.size(); ++i) {
      if (!isCleanIn(i)) continue;
      lengths[i] = lengthOf(site_.runs[i].shapes[matchIn(i).areas[0]].polygon);
      all.push_back({lengths[i], site_.runs[i].weight});
    }
    if (all.size() < 2) return;
    const double consensus = *weightedMedian(all);
    for (std::size_t i = 0; i < lengths.size(); ++i)
      if (lengths[i] > 0) result.runs[i].lengthError = lengths[i] - consensus;
  }

  const SiteAreas& site_;
  const ConsensusRooms& consensus_;
  const std::vector<std::size_t>& judges_;
  const std::vector<RoomsInRun>& inRuns_;
  const RoomDoors& doors_;
  std::size_t room_;
  const SiteShape& shape_;
};

/** R1, R2, ... and C1, C2, ..., largest first. */
void number(std::vector<SiteRoom>& rooms) {
  std::vector<std::size_t> order = numbersFrom(0, rooms.size());
  sortBy(order, [&](std::size_t s) { return std::make_tuple(-rooms[s].area, rooms[s].center); });
  int roomCount = 0, corridorCount = 0;
  for (const std::size_t s : order) {
    rooms[s].id = rooms[s].isCorridor ? "C" + std::to_string(++corridorCount)
                                      : "R" + std::to_string(++roomCount);
    rooms[s].name = rooms[s].id;
  }
}

std::vector<std::string> namesOf(const Site& site, const std::vector<std::size_t>& runs) {
  auto names = mapped(runs, [&](std::size_t run) { return site.runs[run]->name; });
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::vector<SiteRoom> siteRooms(const Site& site, const Consensus& agreed, const Trust& trust,
                                const ForEach& forEach) {
  const SiteAreas areas = siteAreas(site, agreed, trust);
  const ConsensusRooms consensus = consensusRooms(areas, forEach);
  std::vector<SiteRoom> rooms(consensus.rooms.shapes.size());
  std::vector<RoomDoors> doors(rooms.size());
  const auto judges = judgesOf(areas, consensus);
  const std::vector<RoomsInRun> runs = roomsInRuns(areas, consensus, judges, forEach);
  forEach(rooms.size(), [&](std::size_t s) {
    doors[s] = roomDoors(areas, consensus, s, runs);
    rooms[s] = Ledger(areas, consensus, judges[s], runs, doors[s], s).room();
  });
  number(rooms);
  for (std::size_t s = 0; s < rooms.size(); ++s) {
    for (const RoomDoors::Door& door : doors[s].doors)
      rooms[s].doors.push_back({door.place(), door.width(), door.to ? rooms[*door.to].id : "",
                                namesOf(site, door.seenIn), namesOf(site, door.lostIn)});
    for (std::size_t i = 0; i < site.runs.size(); ++i) rooms[s].runs[i].run = site.runs[i]->name;
  }
  sortRooms(rooms);
  return rooms;
}

void sortRooms(std::vector<SiteRoom>& rooms) {
  sortBy(rooms, [](const SiteRoom& room) {
    return std::make_tuple(room.isCorridor, room.id.size(), room.id);
  });
}

}  // namespace roomgraph
