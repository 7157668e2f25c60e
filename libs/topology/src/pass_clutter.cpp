#include "roomgraph/topology/pass_clutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/topology/VoronoiGraph.h"

namespace roomgraph {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/** Whether `a` is missed less than `b`: it is narrower, or as narrow and shorter, as the ways
 *  between the chairs of a row are. */
bool isWorse(const Path& a, const Path& b) {
  if (a.minClearance < b.minClearance * (1 - kSameWidth)) return true;
  return a.minClearance < b.minClearance * (1 + kSameWidth) &&
         a.length < b.length * (1 - kSameWidth);
}

/** The obstacle to the left of a segment of a path in the path's direction, or to its right. Of the
 *  two, which mirror each other, the path knows either. */
Point obstacleBeside(const Path& path, std::size_t segment, bool onLeft) {
  const Point a = path.points[segment], along = path.points[segment + 1] - a;
  const Point known = path.obstacles[segment];
  const double side = cross(along, known - a);
  if ((side > 0) == onLeft) return known;
  return known + (2 * side / squaredNorm(along)) * Point{along.y, -along.x};
}

/** The faces of the graph: what the half edges have to their left. */
struct Faces {
  std::vector<std::uint32_t> of;       ///< per half edge
  std::vector<std::uint8_t> isPassed;  ///< per face: there is but clutter in it
};

/** For each half edge the next one round the face to its left. */
std::vector<HalfEdgeId> roundFaces(const TopologyGraph& graph) {
  const auto bearing = [&](HalfEdgeId h) {
    const Polyline& points = graph.edge(h).path.points;
    const Point out = TopologyGraph::runsAsPath(h) ? points[1] - points[0]
                                                   : points[points.size() - 2] - points.back();
    return std::atan2(out.y, out.x);
  };
  std::vector<HalfEdgeId> next(2 * graph.edges().size());
  std::vector<std::pair<double, HalfEdgeId>> out;
  for (std::size_t v = 0; v < graph.vertices().size(); ++v) {
    out.clear();
    for (const HalfEdgeId h : graph.outgoing(VertexId(v))) out.push_back({bearing(h), h});
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first, a.second.index()) < std::pair(b.first, b.second.index());
    });
    for (std::size_t i = 0; i < out.size(); ++i)
      next[TopologyGraph::twin(out[(i + 1) % out.size()].second).index()] = out[i].second;
  }
  return next;
}

/** One round of removals. */
class ClutterPasser {
 public:
  ClutterPasser(const TopologyGraph& graph, const PlaceTest& isClutter)
      : graph_(graph), faces_(facesOf(graph, isClutter)) {}

  /** Which edges stay. Worst edges join pieces of clutter to groups. All those of a group go if
   *  they are no more than its pieces less one, or one more if it also joins what is no clutter. */
  std::vector<bool> keptEdges() const {
    const std::vector<EdgeId> worst = worstEdges();
    UnionFind groups(faces_.isPassed.size());
    for (const EdgeId e : worst)
      if (isPassed(left(e)) && isPassed(right(e))) groups.join(left(e), right(e));
    std::vector<int> spare(faces_.isPassed.size(), -1);
    std::vector<std::uint8_t> isAtWall(spare.size());
    for (std::uint32_t face = 0; face < spare.size(); ++face) ++spare[groups.find(face)];
    for (const EdgeId e : worst) {
      const std::uint32_t group = groups.find(isPassed(left(e)) ? left(e) : right(e));
      --spare[group];
      if (!isPassed(left(e)) || !isPassed(right(e))) isAtWall[group] = 1;
    }
    std::vector<bool> isKept(graph_.edges().size(), true);
    for (const EdgeId e : worst) {
      const std::uint32_t group = groups.find(isPassed(left(e)) ? left(e) : right(e));
      if (spare[group] + isAtWall[group] >= 0) isKept[e.index()] = false;
    }
    return isKept;
  }

 private:
  static Faces facesOf(const TopologyGraph& graph, const PlaceTest& isClutter) {
    const std::vector<HalfEdgeId> next = roundFaces(graph);
    Faces faces{std::vector<std::uint32_t>(next.size(), kNone), {}};
    for (std::size_t first = 0; first < next.size(); ++first) {
      if (faces.of[first] != kNone) continue;
      std::uint8_t isPassed = 1;
      std::size_t h = first;
      do {
        faces.of[h] = std::uint32_t(faces.isPassed.size());
        isPassed = isPassed && hasClutterOnly(graph.edge(HalfEdgeId(h)).path,
                                              TopologyGraph::runsAsPath(HalfEdgeId(h)), isClutter);
        h = next[h].index();
      } while (h != first);
      faces.isPassed.push_back(isPassed);
    }
    return faces;
  }

  static bool hasClutterOnly(const Path& path, bool onLeft, const PlaceTest& isClutter) {
    for (std::size_t i = 0; i < path.obstacles.size(); ++i)
      if (!isClutter(obstacleBeside(path, i, onLeft))) return false;
    return true;
  }

  std::uint32_t left(EdgeId e) const { return faces_.of[2 * e.index()]; }
  std::uint32_t right(EdgeId e) const { return faces_.of[2 * e.index() + 1]; }
  bool isPassed(std::uint32_t face) const { return faces_.isPassed[face] != 0; }

  /** The edges that are the worst of those round a piece of clutter, ascending; equal ones all. */
  std::vector<EdgeId> worstEdges() const {
    std::vector<EdgeId> beside;
    std::vector<std::uint32_t> worst(faces_.isPassed.size(), kNone);  // per face
    for (std::size_t i = 0; i < graph_.edges().size(); ++i) {
      const EdgeId e(i);
      if (left(e) == right(e)) continue;
      if (!isPassed(left(e)) && !isPassed(right(e))) continue;
      beside.push_back(e);
      for (const std::uint32_t face : {left(e), right(e)})
        if (worst[face] == kNone ||
            isWorse(graph_.edge(e).path, graph_.edge(EdgeId(worst[face])).path))
          worst[face] = std::uint32_t(i);
    }
    const auto isWorstOf = [&](EdgeId e, std::uint32_t face) {
      return isPassed(face) && !isWorse(graph_.edge(EdgeId(worst[face])).path, graph_.edge(e).path);
    };
    std::vector<EdgeId> found;
    for (const EdgeId e : beside)
      if (isWorstOf(e, left(e)) || isWorstOf(e, right(e))) found.push_back(e);
    return found;
  }

  const TopologyGraph& graph_;
  Faces faces_;
};

/** The middle of the part of an edge that leads on from both of its ends [m]. */
std::optional<double> leadingOn(const TopologyGraph& graph, const Edge& edge,
                                const LeadsOn& leadsOn) {
  const Path& path = edge.path;
  std::optional<double> first;
  double along = 0, last = 0;
  for (std::size_t i = 1; i < path.obstacles.size(); ++i) {
    const Point on = path.points[i];
    along += distance(path.points[i - 1], on);
    const Vertex place{on, distance(on, path.obstacles[i - 1]), {}, {}};
    if (!leadsOn(place, graph.vertex(edge.source)) || !leadsOn(place, graph.vertex(edge.target)))
      continue;
    if (!first) first = along;
    last = along;
  }
  if (first) *first = (*first + last) / 2;
  return first;
}

/** A way that enters a region on one side of a piece of clutter, and leaves it on the other, is two
 *  ways into it: so one of them can go without the other. Splits edges that are not kept; returns
 *  whether there was one to split. */
bool splitInRegions(TopologyGraph& graph, const std::vector<bool>& isKept, const LeadsOn& leadsOn) {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < isKept.size(); ++e) {
    if (isKept[e]) continue;
    const std::optional<double> at = leadingOn(graph, graph.edges()[e], leadsOn);
    if (!at) continue;
    if (edges.empty()) vertices = graph.vertices(), edges = graph.edges();
    const Path whole = std::move(edges[e].path);
    const VertexId middle(vertices.size()), target = edges[e].target;
    vertices.push_back({placeOn(whole, *at), clearanceAt(whole, *at), VertexKind::junction, {}});
    edges[e] = {edges[e].source, middle, piece(whole, 0, *at), {}};
    edges.push_back({middle, target, piece(whole, *at, whole.length), {}});
  }
  if (edges.empty()) return false;
  graph = {std::move(vertices), std::move(edges)};
  return true;
}

}  // namespace

TopologyGraph passClutter(TopologyGraph graph, const PlaceTest& isClutter,
                          const ObstacleRows& walls, const DeadEndsOptions& options,
                          const LeadsOn& leadsOn) {
  for (;;) {
    std::vector<bool> keepEdge = ClutterPasser(graph, isClutter).keptEdges();
    if (!contains(keepEdge, false)) return graph;
    if (splitInRegions(graph, keepEdge, leadsOn)) {
      keepEdge = ClutterPasser(graph, isClutter).keptEdges();
      if (!contains(keepEdge, false)) return dissolveThrough(std::move(graph));
    }
    const std::vector<bool> keepVertex(graph.vertices().size(), true);
    graph = dissolveThrough(keepOnly(std::move(graph), keepVertex, keepEdge));
    graph = removeEndsAmongClutter(std::move(graph), options, walls, leadsOn);
  }
}

}  // namespace roomgraph
