#include "measure_table.h"

#include <algorithm>

#include "map_measures.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/measures/Measure.h"

namespace roomgraph {
namespace {

using Known = const SiteEvidence&;
using Index = std::size_t;  // of a run

/** A quantile of the distances between the walls of a run and those of the others. */
MeasureRow wallDistance(const MeasureKind& kind, double share) {
  return {kind,
          [share](Known all, Index run) {
            return wallDistanceOf(all.sightings.distances, all.trust, run, share);
          },
          [share](Known all, Index a, Index b) {
            return wallDistanceOfPair(all.sightings.distances, a, b, share);
          }};
}

MeasureRow ofSightings(const MeasureKind& kind,
                       MeasuredValue (*figure)(const SightingTable&, const DistinctMaps&,
                                               const Trust&, Index)) {
  return {kind,
          [figure](Known all, Index run) {
            return figure(all.sightings, all.maps, all.witnesses, run);
          },
          {}};
}

MeasureRow ofMap(const MeasureKind& kind, MeasuredValue (*figure)(const Run&)) {
  return {kind, [figure](Known all, Index run) { return figure(*all.site.runs[run]); }, {}};
}

std::vector<MeasureRow> wallRows() {
  return {{{"coverage", "Coverage", "1", kFewestThings},
           [](Known all, Index run) { return all.coverage[run]; },
           {}},
          {{"bend", "Bend away from the others", "m", kFewestWalls},
           [](Known all, Index run) { return bendOf(all.bends, all.maps, all.trust, run); },
           [](Known all, Index a, Index b) { return bendOfPair(all.bends(a, b)); }},
          {{"followed", "Walls found again", "1", kFewestWalls},
           {},
           [](Known all, Index a, Index b) { return followedOfPair(all.bends(a, b)); }},
          ofMap({"axis_deviation", "Walls off right angles, median", "deg", 0}, axisDeviationOf),
          {{"wall_distance_mean", "Wall distance, mean", "m", kFewestWalls},
           {},
           [](Known all, Index a, Index b) {
             return meanWallDistanceOfPair(all.sightings.distances, a, b);
           }}};
}

std::vector<MeasureRow> wallPlaceRows() {
  return {
      wallDistance({"wall_distance", "Wall distance, median", "m", kFewestWalls}, 0.5),
      wallDistance({"wall_distance_p90", "Wall distance, 9 of 10 below", "m", kFewestWalls}, 0.9),
      ofSightings({"walls_missing", "Walls of the others that are gone", "1", kFewestWalls},
                  wallsMissingOf),
      ofSightings({"walls_added", "Walls that no other has", "1", kFewestWalls}, wallsAddedOf),
      ofSightings({"straight_walls_added", "Straight walls that no other has", "1", kFewestWalls},
                  straightWallsAddedOf)};
}

std::vector<MeasureRow> roomRows() {
  return {{{"rooms_matched", "Rooms found again", "1", 3},
           [](Known all, Index run) { return roomsMatchedOf(all.rooms, all.trust, run); },
           {}},
          {{"room_coverage", "Room area of the others that it has", "1", kFewestThings},
           [](Known all, Index run) { return roomCoverageOf(all.rooms, all.trust, run); },
           {}}};
}

MeasureRow ofGraphs(const MeasureKind& kind, const GraphFigure& figure) {
  return {
      kind,
      [figure](Known all, Index run) { return graphMeasureOf(figure, all.graphs, all.trust, run); },
      [figure](Known all, Index a, Index b) {
        return graphMeasureOfPair(figure, all.graphs(a, b));
      }};
}

MeasureRow ofGraphs(const MeasureKind& kind, MeasuredValue GraphComparison::*figure) {
  return ofGraphs(kind, {[figure](const GraphComparison& g, bool) { return g.*figure; }});
}

MeasureRow rmsOfGraphs(const MeasureKind& kind, MeasuredValue GraphComparison::*figure) {
  return ofGraphs(kind, {[figure](const GraphComparison& g, bool) { return g.*figure; }, true});
}

/** `hops` is one of kConsistencyHops. */
GraphFigure consistencyOver(std::size_t hops) {
  const auto found = std::find(kConsistencyHops.begin(), kConsistencyHops.end(), hops);
  const std::size_t k = std::size_t(found - kConsistencyHops.begin());
  return {[k](const GraphComparison& g, bool) { return g.consistency.at(k); }};
}

std::vector<MeasureRow> graphRows() {
  using Graphs = GraphComparison;
  return {
      ofGraphs({"path_coverage", "Paths of the others that it has", "1", 20},
               {[](const Graphs& g, bool isA) { return isA ? g.coverageOfA : g.coverageOfB; }}),
      rmsOfGraphs({"global_accuracy", "Vertices off, RMS", "m", kFewestThings},
                  &Graphs::globalAccuracy),
      rmsOfGraphs({"relative_accuracy", "Vertices off after the best fit, RMS", "m", kFewestThings},
                  &Graphs::relativeAccuracy),
      ofGraphs({"consistency_1", "Distances off, 1 hop", "1", kFewestThings}, consistencyOver(1)),
      ofGraphs({"consistency_2", "Distances off, 2 hops", "1", kFewestThings}, consistencyOver(2)),
      ofGraphs({"consistency_4", "Distances off, 4 hops", "1", kFewestThings}, consistencyOver(4)),
      ofGraphs({"consistency_8", "Distances off, 8 hops", "1", kFewestThings}, consistencyOver(8)),
      ofGraphs({"path_length_error", "Path lengths off, median", "1", kFewestThings},
               &Graphs::lengthError),
      ofGraphs({"path_frechet", "Paths apart (Fréchet), median", "m", kFewestThings},
               &Graphs::frechet),
      ofGraphs({"nearest_vertex", "Nearest vertex, mean", "m", kFewestThings},
               {[](const Graphs& g, bool isA) { return isA ? g.nearestA : g.nearestB; }})};
}

std::vector<MeasureRow> mapRows() {
  return {
      {{"brokenness", "Extra pieces", "pieces", kFewestWalls},
       [](Known all, Index run) {
         return brokennessOf(all.site, all.pairs, all.trust, run, all.breaks[run].size());
       },
       {}},
      ofMap({"wall_doubling", "Walls drawn twice", "1", kFewestWalls}, wallDoublingOf),
      ofMap({"wall_sharpness", "Wall cells for each at the edge of free space", "1", kFewestWalls},
            wallSharpnessOf),
      ofMap({"scan_disagreement", "Scans off another visit, 9 of 10 below", "m", kFewestThings},
            [](const Run& run) { return scanDisagreement(run.scans); })};
}

}  // namespace

const std::vector<MeasureRow>& measureTable() {
  static const std::vector<MeasureRow> table = [] {
    std::vector<MeasureRow> rows;
    for (const auto& some : {wallRows(), wallPlaceRows(), roomRows(), graphRows(), mapRows()})
      rows.insert(rows.end(), some.begin(), some.end());
    return rows;
  }();
  return table;
}

const std::vector<MeasureKind>& runMeasureKinds() {
  static const auto kinds = [] {
    std::vector<MeasureKind> ofRuns;
    for (const MeasureRow& row : measureTable())
      if (row.ofRun) ofRuns.push_back(row.kind);
    return ofRuns;
  }();
  return kinds;
}

const MeasureKind* findMeasureKind(const std::string& name) {
  for (const MeasureRow& row : measureTable())
    if (row.kind.name == name) return &row.kind;
  return nullptr;
}

const Measure* find(const std::vector<Measure>& measures, const std::string& name) {
  return findIf(measures, [&](const Measure& measure) { return measure.name == name; });
}

std::optional<double> valueOf(const std::vector<Measure>& measures, const std::string& name) {
  const Measure* measure = find(measures, name);
  return measure ? measure->value : std::nullopt;
}

std::optional<double> trustedValueOf(const std::vector<Measure>& measures,
                                     const std::string& name) {
  const Measure* measure = find(measures, name);
  return measure && measure->isMeaningful ? measure->value : std::nullopt;
}

}  // namespace roomgraph
