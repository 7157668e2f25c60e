#include "run_measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fitted_measures.h"
#include "roomgraph/align/shared_edges.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/Polygon.h"

namespace roomgraph {
namespace {

/** Cells by who has seen them free. */
struct SeenCells {
  /** Of edits of one picture, which may be placed apart, only the first is a witness. */
  struct Witnesses {
    std::uint32_t count = 0, first = 0, last = 0;
  };
  std::vector<Witnesses> witnesses;
  std::vector<std::vector<bool>> by;
};

/** Whose word counts on what there is to be seen: the two best, and who is not far behind. */
std::vector<bool> witnessesOf(const DistinctMaps& maps, const Trust& trust) {
  std::vector<double> sorted;
  for (std::size_t i = 0; i < trust.size(); ++i)
    if (maps.isVoice(i)) sorted.push_back(trust[i]);
  std::sort(sorted.rbegin(), sorted.rend());
  const double least = sorted.size() > 1 ? fitted::kLeastTrust * sorted[1] : 0;
  std::vector<bool> isWitness;
  for (std::size_t i = 0; i < trust.size(); ++i)
    isWitness.push_back(maps.isVoice(i) && trust[i] >= least);
  return isWitness;
}

SeenCells seenCells(const Site& site, const GridFrame& frame, const std::vector<bool>& isWitness) {
  SeenCells seen{std::vector<SeenCells::Witnesses>(frame.cellCount()), {}};
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    std::vector<bool> by(frame.cellCount());
    const Motion2D back(site.poses[i].inverse());
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        if (!isFreeIn(site.runs[i]->map, back(frame.center({x, y})))) continue;
        const std::size_t cell = frame.index({x, y});
        by[cell] = true;
        if (!isWitness[i]) continue;
        SeenCells::Witnesses& witnesses = seen.witnesses[cell];
        if (witnesses.count++ == 0) witnesses.first = std::uint32_t(i);
        witnesses.last = std::uint32_t(i);
      }
    seen.by.push_back(std::move(by));
  }
  return seen;
}

/** Cells that enough witnesses have seen. */
struct CountedCells {
  double all = 0;
  std::vector<double> mine;                   ///< of each run
  std::vector<double> lost;                   ///< those that do not count without this witness
  std::vector<std::vector<double>> lostToMe;  ///< of those of a run, without another

  CountedCells(const SeenCells& seen, std::size_t runs, std::size_t enough)
      : mine(runs), lost(runs), lostToMe(runs, std::vector<double>(runs)) {
    for (std::size_t cell = 0; cell < seen.witnesses.size(); ++cell) {
      const SeenCells::Witnesses& witnesses = seen.witnesses[cell];
      if (witnesses.count < enough) continue;
      ++all;
      for (std::size_t i = 0; i < runs; ++i) mine[i] += seen.by[i][cell] ? 1 : 0;
      if (witnesses.count != 2) continue;
      for (const std::uint32_t j : {witnesses.first, witnesses.last}) {
        ++lost[j];
        for (std::size_t i = 0; i < runs; ++i) lostToMe[i][j] += seen.by[i][cell] ? 1 : 0;
      }
    }
  }
};

void widen(MeasuredValue& measured, double value) {
  measured.low = std::min(*measured.low, value), measured.high = std::max(*measured.high, value);
}

/** From the walls of either run to those of the other. */
WallDistances bothWays(const DistanceTable& distances, std::size_t a, std::size_t b) {
  WallDistances both = distances(a, b);
  both.add(distances(b, a));
  return both;
}

MeasuredValue measuredIn(const WallDistances& both, double value) {
  return {both.count > 0 ? std::optional(value) : std::nullopt, both.count};
}

bool isNothing(const Transform2D& pose) {
  constexpr double kTiny = 1e-6;
  return std::abs(pose.x) < kTiny && std::abs(pose.y) < kTiny && std::abs(pose.phi) < kTiny;
}

}  // namespace

GridFrame siteFrame(const Site& site) {
  Box box;
  double cell = kWallCell;
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    cell = std::max(cell, site.runs[i]->map.frame.resolution);
    for (const WallPoint& wall : site.runs[i]->map.walls) box.include(site.poses[i](wall.place));
  }
  if (box.isEmpty()) return {1, 1, cell, {}};
  return {int(box.size().x / cell) + 1, int(box.size().y / cell) + 1, cell, box.low};
}

bool isFreeIn(const WallMap& map, Point p) { return stateAt(map, p) == State::free; }

std::vector<MeasuredValue> coverageOf(const Site& site, const DistinctMaps& maps,
                                      const Trust& trust) {
  const GridFrame frame = siteFrame(site);
  const std::size_t n = site.runs.size();
  const CountedCells cells(seenCells(site, frame, witnessesOf(maps, trust)), n,
                           std::min<std::size_t>(2, maps.count()));
  std::vector<MeasuredValue> coverage(n);
  if (cells.all == 0 || n < 2) return coverage;
  for (std::size_t i = 0; i < n; ++i) {
    coverage[i].value = cells.mine[i] / cells.all, coverage[i].support = cells.all;
    coverage[i].hasEnoughOthers = maps.count() > kFewestOthers;
    coverage[i].worth = frame.resolution * frame.resolution;
    if (maps.count() > 2) coverage[i].low = coverage[i].high = coverage[i].value;
    for (std::size_t j = 0; coverage[i].low && j < n; ++j)
      if (maps.isMeasuredAgainst(i, j) && cells.all > cells.lost[j])
        widen(coverage[i], (cells.mine[i] - cells.lostToMe[i][j]) / (cells.all - cells.lost[j]));
  }
  return coverage;
}

MeasuredValue bendOf(const PairBends& bends, const DistinctMaps& maps, const Trust& trust,
                     std::size_t run) {
  std::vector<ShareInOther> others;
  for (const std::size_t j : bends.othersOf(run)) {
    const PairBend& bend = bends(run, j);
    const double weight = maps.isMeasuredAgainst(run, j) ? trust[j] * bend.share : 0;
    others.push_back({weight > 0 ? bend.walls : 0, weight * bend.bend, weight});
  }
  return shareOverOthers(others);
}

MeasuredValue bendOfPair(const PairBend& bend) {
  return {bend.share > 0 ? std::optional(bend.bend) : std::nullopt, bend.walls};
}

MeasuredValue followedOfPair(const PairBend& bend) { return {bend.share, bend.walls}; }

MeasuredValue axisDeviationOf(const Run& run) {
  std::optional<double> degrees;
  if (run.map.axisDeviation) degrees = *run.map.axisDeviation * 180 / M_PI;
  return {degrees, double(run.map.walls.size())};
}

MeasuredValue wallDistanceOf(const DistanceTable& distances, const Trust& trust, std::size_t run,
                             double share) {
  const std::vector<std::size_t>& others = distances.othersOf(run);
  std::vector<double> supports;
  for (const std::size_t j : others) supports.push_back(trust[j] > 0 ? distances(run, j).count : 0);
  return measureOverOthers(supports, [&](std::size_t but) {
    WallDistances all;
    for (std::size_t k = 0; k < others.size(); ++k)
      if (k != but) all.add(distances(run, others[k]), trust[others[k]]);
    return all.quantile(share);
  });
}

MeasuredValue wallDistanceOfPair(const DistanceTable& distances, std::size_t a, std::size_t b,
                                 double share) {
  const WallDistances both = bothWays(distances, a, b);
  return measuredIn(both, both.quantile(share));
}

MeasuredValue meanWallDistanceOfPair(const DistanceTable& distances, std::size_t a, std::size_t b) {
  const WallDistances both = bothWays(distances, a, b);
  return measuredIn(both, both.mean());
}

void WallDistances::add(const WallDistances& other, double weight) {
  sum += weight * other.sum;
  count += weight * other.count;
  for (std::size_t i = 0; i < histogram.size(); ++i) histogram[i] += weight * other.histogram[i];
}

double WallDistances::quantile(double share) const {
  std::vector<WeightedValue> distances;
  for (std::size_t i = 0; i < histogram.size(); ++i)
    distances.push_back({double(i) * kStep, histogram[i]});
  return weightedQuantile(std::move(distances), share).value_or(0);
}

WallDistances wallDistances(const WallMap& map, const WallMap& other, const Transform2D& pose) {
  WallDistances result;
  // The table holds the wall that is nearest to the middle of a cell, which may be another one.
  const bool isItself = isNothing(pose) && areIdentical(map, other);
  const Motion2D forth(pose);
  for (const WallPoint& wall : map.walls) {
    const WallLookUp there = lookUp(wall, other, forth);
    if (!there.isKnown) continue;
    double apart = there.wall ? distance(there.wall->place, there.place) : WallMap::kReach;
    apart = isItself ? 0 : std::min(apart, WallMap::kReach);
    result.sum += apart;
    result.count += 1;
    result.histogram[std::size_t(std::lround(apart / WallDistances::kStep))] += 1;
  }
  return result;
}

}  // namespace roomgraph
