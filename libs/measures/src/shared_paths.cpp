#include "shared_paths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <tuple>

#include "fitted_measures.h"
#include "roomgraph/base/OneToOne.h"
#include "roomgraph/base/sequences.h"

namespace roomgraph {
namespace {

/** Of each vertex the match that it is part of. */
using MatchOf = std::vector<std::optional<std::size_t>>;

struct Way {
  std::vector<HalfEdgeId> steps;
  double length = 0;
};

/** From one matched vertex to the others, each by the shortest way past no matched vertex. */
class WaysOut {
 public:
  WaysOut(const TopologyGraph& graph, MatchOf matchOf)
      : graph_(graph),
        matchOf_(std::move(matchOf)),
        length_(graph.vertices().size(), HUGE_VAL),
        before_(graph.vertices().size()) {}

  /** By match; only those above the one of `start`. */
  std::map<std::size_t, Way> from(VertexId start) {
    search(start);
    std::map<std::size_t, Way> ways;
    for (const VertexId v : reached_) {
      const auto match = matchOf_[v.index()];
      if (match && match > matchOf_[start.index()]) ways[*match] = wayTo(v, start);
    }
    for (const VertexId v : reached_) length_[v.index()] = HUGE_VAL;
    return ways;
  }

 private:
  void search(VertexId start) {
    using Entry = std::pair<double, VertexId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    reached_ = {start};
    length_[start.index()] = 0;
    queue.push({0, start});
    while (!queue.empty()) {
      const auto [length, v] = queue.top();
      queue.pop();
      if (length > length_[v.index()]) continue;
      if (v != start && matchOf_[v.index()]) continue;
      for (const HalfEdgeId h : graph_.outgoing(v)) {
        const VertexId to = graph_.target(h);
        const double next = length + graph_.edge(h).path.length;
        if (next > fitted::kMaxPathLength || next >= length_[to.index()]) continue;
        if (length_[to.index()] == HUGE_VAL) reached_.push_back(to);
        length_[to.index()] = next, before_[to.index()] = h;
        queue.push({next, to});
      }
    }
  }

  Way wayTo(VertexId v, VertexId start) const {
    Way way;
    way.length = length_[v.index()];
    for (; v != start; v = graph_.source(way.steps.back())) way.steps.push_back(before_[v.index()]);
    std::reverse(way.steps.begin(), way.steps.end());
    return way;
  }

  const TopologyGraph& graph_;
  MatchOf matchOf_;
  std::vector<double> length_;
  std::vector<HalfEdgeId> before_;
  std::vector<VertexId> reached_;
};

using Ends = std::pair<std::size_t, std::size_t>;

/** The edges between matched vertices, by their matches, as half edges from the lower one. */
std::map<Ends, std::vector<HalfEdgeId>> edgesBetween(const TopologyGraph& graph,
                                                     const MatchOf& matchOf) {
  std::map<Ends, std::vector<HalfEdgeId>> edges;
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    auto from = matchOf[edge.source.index()], to = matchOf[edge.target.index()];
    if (!from || !to) continue;
    HalfEdgeId h(2 * e);
    if (to < from) std::swap(from, to), h = TopologyGraph::twin(h);
    edges[{*from, *to}].push_back(h);
  }
  return edges;
}

void matchEdges(const TopologyGraph& a, const TopologyGraph& b, Ends ends,
                const std::vector<HalfEdgeId>& ofA, const std::vector<HalfEdgeId>& ofB,
                std::vector<PathMatch>& paths) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < ofA.size(); ++i)
    for (std::size_t j = 0; j < ofB.size(); ++j) {
      const double l = a.edge(ofA[i]).path.length, m = b.edge(ofB[j]).path.length;
      if (isSameLength(l, m)) pairs.push_back({std::abs(l - m), i, j});
    }
  std::sort(pairs.begin(), pairs.end());
  OneToOne pairing(ofA.size(), ofB.size());
  for (const auto& [apart, i, j] : pairs) {
    if (!pairing.take(i, j)) continue;
    paths.push_back({ends.first,
                     ends.second,
                     {ofA[i]},
                     {ofB[j]},
                     a.edge(ofA[i]).path.length,
                     b.edge(ofB[j]).path.length});
  }
}

}  // namespace

bool isSameLength(double a, double b) {
  return std::abs(a - b) <= std::max(fitted::kLengthSlack, fitted::kLengthShare * std::max(a, b));
}

std::vector<PathMatch> sharedPaths(const TopologyGraph& a, const TopologyGraph& b,
                                   const std::vector<VertexMatch>& vertices) {
  MatchOf ofA(a.vertices().size()), ofB(b.vertices().size());
  for (std::size_t m = 0; m < vertices.size(); ++m)
    ofA[vertices[m].a.index()] = ofB[vertices[m].b.index()] = m;
  const auto edgesA = edgesBetween(a, ofA), edgesB = edgesBetween(b, ofB);
  std::vector<PathMatch> paths;
  for (const auto& [ends, edges] : edgesA)
    if (const auto other = edgesB.find(ends); other != edgesB.end())
      matchEdges(a, b, ends, edges, other->second, paths);
  std::map<Ends, bool> isDone;
  for (const PathMatch& path : paths) isDone[{path.from, path.to}] = true;
  WaysOut outA(a, ofA), outB(b, ofB);
  for (std::size_t m = 0; m < vertices.size(); ++m) {
    auto waysA = outA.from(vertices[m].a), waysB = outB.from(vertices[m].b);
    for (auto& [to, way] : waysA) {
      const auto other = waysB.find(to);
      if (other == waysB.end() || isDone.count({m, to})) continue;
      if (!isSameLength(way.length, other->second.length)) continue;
      paths.push_back({m, to, std::move(way.steps), std::move(other->second.steps), way.length,
                       other->second.length});
    }
  }
  sortBy(paths, [](const PathMatch& path) { return std::tie(path.from, path.to); });
  return paths;
}

}  // namespace roomgraph
