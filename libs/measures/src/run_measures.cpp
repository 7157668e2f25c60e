#include "run_measures.h"

#include <algorithm>
#include <cmath>

#include "measure_over_others.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/match/match_rooms.h"
#include "roomgraph/relate/DistinctMaps.h"

namespace roomgraph {
namespace {

constexpr double kMinArea = 10;  // of the site, for a coverage that means something [m2]
constexpr std::size_t kMinRuns = 3;

/** A frame around all placed runs. */
GridFrame siteFrame(const Site& site) {
  Point low{1e30, 1e30}, high{-1e30, -1e30};
  double cell = 0.1;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    cell = std::max(cell, site.runs[i]->map.frame.resolution);
    for (const WallPoint& wall : site.runs[i]->map.walls) {
      const Point p = site.poses[i](wall.place);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return {int((high.x - low.x) / cell) + 1, int((high.y - low.y) / cell) + 1, cell, low};
}

bool isFreeIn(const MapForAlignment& map, Point p) {
  const std::size_t cell = cellIndexAt(map.frame, p);
  return cell < map.states.size() && map.states[cell] == State::free;
}

/** Cells by who has seen them free. */
struct SeenCells {
  /** Of runs with the same map, which may be placed apart, only the first is a witness. */
  struct Witnesses {
    std::uint32_t count = 0, first = 0, last = 0;
  };
  std::vector<Witnesses> witnesses;
  std::vector<std::vector<bool>> by;
};

SeenCells seenCells(const Site& site, const GridFrame& frame, const DistinctMaps& maps) {
  SeenCells seen{std::vector<SeenCells::Witnesses>(frame.cellCount()), {}};
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    std::vector<bool> by(frame.cellCount());
    const Motion2D back(site.poses[i].inverse());
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        if (!isFreeIn(site.runs[i]->map, back(frame.center({x, y})))) continue;
        const std::size_t cell = frame.index({x, y});
        by[cell] = true;
        if (!maps.isFirst(i)) continue;
        SeenCells::Witnesses& witnesses = seen.witnesses[cell];
        if (witnesses.count++ == 0) witnesses.first = std::uint32_t(i);
        witnesses.last = std::uint32_t(i);
      }
    seen.by.push_back(std::move(by));
  }
  return seen;
}

void widen(Measure& measure, double value) {
  measure.low = std::min(*measure.low, value), measure.high = std::max(*measure.high, value);
}

Measure wallMeasure(const DistanceTable& distances, const Trust& trust, std::size_t run,
                    const char* name, double share) {
  Measure measure = measureNamed(name);
  std::vector<double> supports;
  for (std::size_t j = 0; j < trust.size(); ++j)
    supports.push_back(j != run && trust[j] > 0 ? distances(run, j).count : 0);
  measureOverOthers(measure, supports, [&](std::size_t but) {
    WallDistances all;
    for (std::size_t j = 0; j < trust.size(); ++j)
      if (j != run && j != but) all.add(distances(run, j), trust[j]);
    return all.quantile(share);
  });
  return measure;
}

/** The rooms of a run, in the frame of the site. */
std::vector<GraphRoom> roomsInSite(const Run& run, const Transform2D& pose) {
  std::vector<GraphRoom> rooms = run.rooms;
  for (GraphRoom& room : rooms) {
    room.center = pose(room.center);
    for (Point& p : room.shape.polygon.outer) p = pose(p);
    for (Ring& hole : room.shape.polygon.holes)
      for (Point& p : hole) p = pose(p);
  }
  return rooms;
}

/** How many rooms of another run this one could have, and how many it has. */
struct RoomCount {
  double visible = 0, matched = 0;
  double area = 0, matchedArea = 0;  ///< of all rooms of the other, and of those it has [m2]
};

RoomCount countRooms(const std::vector<GraphRoom>& others, std::vector<bool> isMatched,
                     const MapForAlignment& map, const Transform2D& back) {
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
Measure roomMeasure(const DirectedTable<RoomCount>& counts, const Trust& trust, std::size_t run,
                    const char* name, double RoomCount::*part, double RoomCount::*all) {
  Measure measure = measureNamed(name);
  std::vector<double> supports;
  for (std::size_t j = 0; j < trust.size(); ++j)
    supports.push_back(j != run && trust[j] > 0 ? counts(run, j).*all : 0);
  measureOverOthers(measure, supports, [&](std::size_t but) -> std::optional<double> {
    RoomCount sum;
    for (std::size_t j = 0; j < trust.size(); ++j) {
      if (j == run || j == but) continue;
      sum.*all += trust[j] * counts(run, j).*all;
      sum.*part += trust[j] * counts(run, j).*part;
    }
    if (sum.*all <= 0) return std::nullopt;
    return sum.*part / sum.*all;
  });
  return measure;
}

}  // namespace

std::vector<Measure> coverageOf(const Site& site, const PairBends& bends) {
  const GridFrame frame = siteFrame(site);
  const DistinctMaps maps(bends);
  const SeenCells seen = seenCells(site, frame, maps);
  const std::size_t n = site.runs.size(), enough = std::min<std::size_t>(2, maps.count());
  double all = 0;
  std::vector<double> mine(n), lost(n);  // cells; those that do not count without this witness
  DirectedTable<double> lostToMe(n);     // of mine, without another
  for (std::size_t cell = 0; cell < seen.witnesses.size(); ++cell) {
    const SeenCells::Witnesses& witnesses = seen.witnesses[cell];
    if (witnesses.count < enough) continue;
    ++all;
    for (std::size_t i = 0; i < n; ++i) mine[i] += seen.by[i][cell] ? 1 : 0;
    if (witnesses.count != 2) continue;
    for (const std::uint32_t j : {witnesses.first, witnesses.last}) {
      ++lost[j];
      for (std::size_t i = 0; i < n; ++i) lostToMe(i, j) += seen.by[i][cell] ? 1 : 0;
    }
  }
  std::vector<Measure> measures(n, measureNamed("coverage"));
  for (std::size_t i = 0; i < n; ++i) {
    measures[i].support = all;
    if (all == 0) continue;
    measures[i].value = mine[i] / all;
    measures[i].isMeaningful =
        maps.count() >= kMinRuns && all * frame.resolution * frame.resolution >= kMinArea;
    if (maps.count() > 2) measures[i].low = measures[i].high = measures[i].value;
    for (std::size_t j = 0; measures[i].low && j < n; ++j)
      if (maps.isMeasuredAgainst(i, j) && all > lost[j])
        widen(measures[i], (mine[i] - lostToMe(i, j)) / (all - lost[j]));
  }
  return measures;
}

Measure bendOf(const PairBends& bends, const Trust& trust, std::size_t run) {
  Measure measure = measureNamed("bend");
  const DistinctMaps maps(bends);
  const auto weightOf = [&](std::size_t j) {
    return maps.isMeasuredAgainst(run, j) ? trust[j] * bends(run, j).share : 0.0;
  };
  std::vector<double> supports;
  for (std::size_t j = 0; j < trust.size(); ++j)
    supports.push_back(weightOf(j) > 0 ? bends(run, j).walls : 0);
  measureOverOthers(measure, supports, [&](std::size_t but) -> std::optional<double> {
    double sum = 0, weights = 0;
    for (std::size_t j = 0; j < trust.size(); ++j) {
      if (j == but || j == run) continue;
      sum += weightOf(j) * bends(run, j).bend, weights += weightOf(j);
    }
    if (weights <= 0) return std::nullopt;
    return sum / weights;
  });
  return measure;
}

Measure axisDeviationOf(const Run& run) {
  std::optional<double> degrees;
  if (run.map.axisDeviation) degrees = *run.map.axisDeviation * 180 / M_PI;
  return measureNamed("axis_deviation", degrees, double(run.map.walls.size()));
}

DistanceTable distancesOf(const Site& site, const ForEach& forEach) {
  const std::size_t n = site.runs.size();
  DistanceTable distances(n);
  forEach(n, [&](std::size_t i) {
    for (std::size_t j = 0; j < n; ++j)
      if (i != j)
        distances(i, j) = wallDistances(site.runs[i]->map, site.runs[j]->map,
                                        site.poses[j].inverse() * site.poses[i]);
  });
  return distances;
}

std::vector<Measure> wallMeasuresOf(const DistanceTable& distances, const Trust& trust,
                                    std::size_t run) {
  return {wallMeasure(distances, trust, run, "wall_distance", 0.5),
          wallMeasure(distances, trust, run, "wall_distance_p90", 0.9)};
}

std::vector<Measure> wallMeasuresOfPair(const PairBend& bend, const DistanceTable& distances,
                                        std::size_t a, std::size_t b) {
  WallDistances both = distances(a, b);
  both.add(distances(b, a));
  const auto distance = [&](const char* name, double value) {
    return measureNamed(name, both.count > 0 ? std::optional(value) : std::nullopt, both.count);
  };
  const auto apart = bend.share > 0 ? std::optional(bend.bend) : std::nullopt;
  return {measureNamed("bend", apart, bend.walls), measureNamed("followed", bend.share, bend.walls),
          distance("wall_distance_mean", both.mean()),
          distance("wall_distance", both.quantile(0.5)),
          distance("wall_distance_p90", both.quantile(0.9))};
}

std::vector<std::vector<Measure>> roomMeasuresOf(const Site& site, const Trust& trust,
                                                 const ForEach& forEach) {
  const GridFrame frame = siteFrame(site);
  const std::size_t n = site.runs.size();
  std::vector<std::vector<GraphRoom>> rooms;
  for (std::size_t i = 0; i < n; ++i) rooms.push_back(roomsInSite(*site.runs[i], site.poses[i]));
  DirectedTable<RoomCount> counts(n);
  forEach(n, [&](std::size_t i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      std::vector<bool> ofI(rooms[i].size()), ofJ(rooms[j].size());
      for (const MatchedRooms& match : matchRooms(rooms[i], rooms[j], frame)) {
        ofI[match.base.index()] = true;
        ofJ[match.other.index()] = true;
      }
      counts(i, j) = countRooms(rooms[j], ofJ, site.runs[i]->map, site.poses[i].inverse());
      counts(j, i) = countRooms(rooms[i], ofI, site.runs[j]->map, site.poses[j].inverse());
    }
  });
  std::vector<std::vector<Measure>> measures;
  for (std::size_t i = 0; i < n; ++i)
    measures.push_back(
        {roomMeasure(counts, trust, i, "rooms_matched", &RoomCount::matched, &RoomCount::visible),
         roomMeasure(counts, trust, i, "room_coverage", &RoomCount::matchedArea,
                     &RoomCount::area)});
  return measures;
}

}  // namespace roomgraph
