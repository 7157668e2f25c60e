#include "compare_graphs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fitted_measures.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/MotionFit.h"
#include "roomgraph/measures/match_elements.h"

namespace roomgraph {
namespace {

MeasuredValue medianOf(std::vector<double> values) {
  if (values.empty()) return {};
  const double count = double(values.size());
  return {median(std::move(values)), count};
}

struct PlacePair {
  Point a, b;
};

std::vector<PlacePair> placesOf(const TopologyGraph& a, const TopologyGraph& b,
                                const GraphMatch& match) {
  return mapped(match.vertices, [&](const VertexMatch& m) {
    return PlacePair{a.vertex(m.a).place, b.vertex(m.b).place};
  });
}

/** Of the distances that the best turn and shift leaves. */
double squaresAfterFit(const std::vector<PlacePair>& places) {
  MotionFit best;
  for (const PlacePair& p : places) best.add(p.b, p.a);
  const Motion2D fit(best.motion());
  double squares = 0;
  for (const PlacePair& p : places) squares += squaredNorm(fit(p.b) - p.a);
  return squares;
}

Polyline lineOf(const TopologyGraph& graph, const std::vector<HalfEdgeId>& steps) {
  Polyline line;
  for (const HalfEdgeId h : steps) {
    const Polyline& points = graph.edge(h).path.points;
    const auto add = [&](auto first, auto last) {
      line.insert(line.end(), line.empty() ? first : first + 1, last);
    };
    if (TopologyGraph::runsAsPath(h))
      add(points.begin(), points.end());
    else
      add(points.rbegin(), points.rend());
  }
  return line;
}

/** Paths inside of rooms are straight by construction: their lengths say all of them. */
bool isInRoom(const TopologyGraph& graph, const std::vector<HalfEdgeId>& steps) {
  return allOf(steps, [&](HalfEdgeId h) { return bool(graph.edge(h).room); });
}

/** The matched paths as a graph over the matched vertices; lengths are means of both. */
using Steps = std::vector<std::vector<std::pair<std::size_t, double>>>;

Steps stepsOf(const GraphMatch& match) {
  Steps steps(match.vertices.size());
  for (const PathMatch& path : match.paths) {
    if (path.from == path.to) continue;
    const double length = (path.lengthInA + path.lengthInB) / 2;
    steps[path.from].push_back({path.to, length});
    steps[path.to].push_back({path.from, length});
  }
  return steps;
}

/** Compares the distances from one vertex to all those behind it, by hops; of the ways with fewest
 *  hops the shortest counts. */
class HopSearch {
 public:
  HopSearch(const Steps& steps, const std::vector<PlacePair>& places)
      : steps_(steps), places_(places), hops_(steps.size()), length_(steps.size()) {}

  void from(std::size_t start) {
    std::vector<std::size_t> reached{start}, layer{start};
    hops_[start] = 0, length_[start] = 0;
    for (std::size_t hop = 1; hop <= kConsistencyHops.back() && !layer.empty(); ++hop) {
      layer = nextLayer(layer, hop);
      reached.insert(reached.end(), layer.begin(), layer.end());
      const auto kind = std::find(kConsistencyHops.begin(), kConsistencyHops.end(), hop);
      if (kind == kConsistencyHops.end()) continue;
      for (const std::size_t v : layer)
        if (v > start && length_[v] > 0)
          found_[std::size_t(kind - kConsistencyHops.begin())].push_back(
              std::abs(distance(places_[start].a, places_[v].a) -
                       distance(places_[start].b, places_[v].b)) /
              length_[v]);
    }
    for (const std::size_t v : reached) hops_[v] = std::nullopt;
  }

  MeasuredValue consistency(std::size_t kind) const { return medianOf(found_[kind]); }

 private:
  std::vector<std::size_t> nextLayer(const std::vector<std::size_t>& layer, std::size_t hop) {
    std::vector<std::size_t> next;
    for (const std::size_t v : layer)
      for (const auto& [to, length] : steps_[v]) {
        if (!hops_[to]) {
          hops_[to] = hop, length_[to] = length_[v] + length;
          next.push_back(to);
        } else if (hops_[to] == hop) {
          length_[to] = std::min(length_[to], length_[v] + length);
        }
      }
    return next;
  }

  const Steps& steps_;
  const std::vector<PlacePair>& places_;
  std::array<std::vector<double>, kConsistencyHops.size()> found_;
  std::vector<std::optional<std::size_t>> hops_;  // none for those that were not met
  std::vector<double> length_;
};

void comparePaths(const TopologyGraph& a, const TopologyGraph& b, const GraphMatch& match,
                  GraphComparison& result) {
  std::vector<double> lengthErrors, frechets;
  for (const PathMatch& path : match.paths) {
    const double longer = std::max(path.lengthInA, path.lengthInB);
    if (longer <= 0) continue;
    lengthErrors.push_back(std::abs(path.lengthInA - path.lengthInB) / longer);
    if (isInRoom(a, path.a) || isInRoom(b, path.b)) continue;
    if (const auto apart = pathFrechet(lineOf(a, path.a), lineOf(b, path.b)))
      frechets.push_back(*apart);
  }
  result.lengthError = medianOf(std::move(lengthErrors));
  result.frechet = medianOf(std::move(frechets));
}

TopologyGraph placedVertices(const TopologyGraph& graph, const Transform2D& pose) {
  std::vector<Vertex> vertices = graph.vertices();
  for (Vertex& vertex : vertices) vertex.place = pose(vertex.place);
  return {std::move(vertices), {}};
}

MeasuredValue rootMean(double squares, double count) {
  if (count <= 0) return {};
  return {std::sqrt(squares / count), count};
}

MeasuredValue shareOf(double part, double all) {
  if (all <= 0) return {};
  return {part / all, all};
}

/** `steps` + 1 places, evenly along the line. */
std::vector<Point> evenly(const Polyline& line, double length, int steps) {
  std::vector<Point> places{line.front()};
  double along = 0;  // up to the start of the segment
  std::size_t i = 0;
  for (int k = 1; k < steps; ++k) {
    const double want = length * k / steps;
    double segment = distance(line[i], line[i + 1]);
    while (along + segment < want && i + 2 < line.size()) {
      along += segment;
      ++i;
      segment = distance(line[i], line[i + 1]);
    }
    const double share = segment > 0 ? std::min(1.0, (want - along) / segment) : 0;
    places.push_back(line[i] + share * (line[i + 1] - line[i]));
  }
  places.push_back(line.back());
  return places;
}

double frechet(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double left = 0, below = 0;  // of the cell before, in this row and in the last one
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double old = row[j];
      double reached = 0;
      if (i > 0 && j > 0)
        reached = std::min({left, old, below});
      else if (i + j > 0)
        reached = i > 0 ? old : left;
      row[j] = std::max(reached, squaredNorm(a[i] - b[j]));
      below = old, left = row[j];
    }
  }
  return std::sqrt(row.back());
}

}  // namespace

GraphComparison compareGraphs(const TopologyGraph& a, const TopologyGraph& b,
                              const GraphMatch& match, const std::array<Transform2D, 2>& inSite) {
  GraphComparison result;
  result.coverageOfA = shareOf(match.sharedInB, match.overallInB);
  result.coverageOfB = shareOf(match.sharedInA, match.overallInA);
  const std::vector<PlacePair> places = placesOf(a, b, match);
  double squares = 0;
  for (const PlacePair& p : places) squares += squaredNorm(inSite[0](p.a) - inSite[1](p.b));
  result.globalAccuracy = rootMean(squares, double(places.size()));
  if (places.size() > 1)
    result.relativeAccuracy = rootMean(squaresAfterFit(places), double(places.size()));
  comparePaths(a, b, match, result);
  const Steps steps = stepsOf(match);
  HopSearch search(steps, places);
  for (std::size_t v = 0; v < steps.size(); ++v) search.from(v);
  for (std::size_t k = 0; k < kConsistencyHops.size(); ++k)
    result.consistency[k] = search.consistency(k);
  const TopologyGraph inA = placedVertices(a, inSite[0]), inB = placedVertices(b, inSite[1]);
  result.nearestA = {nearestVertices(inA, inB), double(a.vertices().size())};
  result.nearestB = {nearestVertices(inB, inA), double(b.vertices().size())};
  return result;
}

std::optional<double> pathFrechet(const Polyline& a, const Polyline& b) {
  const double ofA = length(a), ofB = length(b);
  if (ofA <= 0 || ofB <= 0) return std::nullopt;
  // Even a short path has a shape, and a long one costs no more than a bounded time.
  const int steps = std::clamp(int(std::max(ofA, ofB) / fitted::kPathStep), 8, 64);
  const std::vector<Point> onA = evenly(a, ofA, steps);
  std::vector<Point> onB = evenly(b, ofB, steps);
  const bool isLoop = distance(a.front(), a.back()) < fitted::kLoop * ofA ||
                      distance(b.front(), b.back()) < fitted::kLoop * ofB;
  MotionFit fit;
  for (std::size_t i = 0; i < onA.size(); ++i)
    if (isLoop || i == 0 || i + 1 == onA.size()) fit.add(onB[i], onA[i]);
  const Motion2D move(fit.motion());
  for (Point& p : onB) p = move(p);
  return frechet(onA, onB);
}

}  // namespace roomgraph
