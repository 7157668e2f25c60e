#include "roomgraph/topology/voronoi_without.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "edge_clearance.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/topology/voronoi_graph.h"

namespace roomgraph {
namespace {

VoronoiEdge flip(VoronoiEdge edge) {
  std::swap(edge.source, edge.target);
  std::swap(edge.left, edge.right);
  return edge;
}

/** Faces of the triangulation that go, connected with each other. */
struct Hole {
  std::vector<std::uint32_t> obstacles;  ///< that stay, round the hole
  std::vector<VoronoiEdge> rim;          ///< edges into the hole; the source stays, or is none
};

class HoleFiller {
 public:
  HoleFiller(const VoronoiGraph& graph, const ObstacleCells& obstacles,
             const std::vector<std::uint8_t>& isLeftOut)
      : graph_(graph), obstacles_(obstacles), isLeftOut_(isLeftOut) {}

  /** Empty where a hole cannot be told from the outside: it reaches the hull, or its rim is
   *  degenerate. */
  std::optional<VoronoiGraph> run() {
    flagVertices();
    result_.obstacles = graph_.obstacles;
    keepTheRest();
    for (Hole& hole : holes())
      if (!fill(hole)) return std::nullopt;
    return std::move(result_);
  }

 private:
  void flagVertices() {
    goes_.assign(graph_.vertices.size(), 0);
    for (const VoronoiEdge& edge : graph_.edges) {
      if (!isLeftOut_[edge.left] && !isLeftOut_[edge.right]) continue;
      goes_[edge.source] = 1;
      if (!edge.isInfinite()) goes_[edge.target] = 1;
    }
  }

  bool goes(std::uint32_t vertex) const {
    return vertex != VoronoiEdge::kNoVertex && goes_[vertex];
  }

  void keepTheRest() {
    newOf_.assign(graph_.vertices.size(), VoronoiEdge::kNoVertex);
    result_.vertices.reserve(graph_.vertices.size());
    result_.edges.reserve(graph_.edges.size());
    for (std::uint32_t v = 0; v < newOf_.size(); ++v) {
      if (goes_[v]) continue;
      newOf_[v] = std::uint32_t(result_.vertices.size());
      result_.vertices.push_back(graph_.vertices[v]);
    }
    for (VoronoiEdge edge : graph_.edges) {
      if (goes(edge.source) || goes(edge.target)) {
        atHoles_.push_back(edge);
        continue;
      }
      edge.source = newOf_[edge.source];
      if (!edge.isInfinite()) edge.target = newOf_[edge.target];
      result_.edges.push_back(edge);
    }
  }

  std::vector<Hole> holes() const {
    UnionFind groups(graph_.vertices.size());
    for (const VoronoiEdge& edge : atHoles_)
      if (goes(edge.source) && goes(edge.target)) groups.join(edge.source, edge.target);
    std::vector<Hole> holes;
    std::unordered_map<std::uint32_t, std::size_t> holeOf;
    for (const VoronoiEdge& edge : atHoles_) {
      const auto group = groups.find(goes(edge.source) ? edge.source : edge.target);
      const auto it = holeOf.try_emplace(group, holes.size()).first;
      if (it->second == holes.size()) holes.emplace_back();
      Hole& hole = holes[it->second];
      for (const auto obstacle : {edge.left, edge.right})
        if (!isLeftOut_[obstacle]) hole.obstacles.push_back(obstacle);
      if (!goes(edge.source)) hole.rim.push_back(edge);
      if (!goes(edge.target)) hole.rim.push_back(flip(edge));
    }
    return holes;
  }

  bool fill(Hole& hole) {
    sortUnique(hole.obstacles);
    ObstacleCells around{obstacles_.frame, {}};
    for (const auto obstacle : hole.obstacles) around.cells.push_back(obstacles_.cells[obstacle]);
    VoronoiGraph local = voronoiGraph(around);
    LocalEdges edges;
    for (std::size_t e = 0; e < local.edges.size(); ++e) {
      VoronoiEdge& edge = local.edges[e];
      edge.left = hole.obstacles[edge.left];
      edge.right = hole.obstacles[edge.right];
      edges.push_back({keyOf(edge), e});
    }
    std::sort(edges.begin(), edges.end());
    return addLocal(hole, local, edges);
  }

  using LocalEdges = std::vector<std::pair<std::uint64_t, std::size_t>>;  // by their keys

  static std::uint64_t keyOf(const VoronoiEdge& edge) {
    const auto [low, high] = std::minmax(edge.left, edge.right);
    return std::uint64_t(low) << 32 | high;
  }

  bool addLocal(const Hole& hole, const VoronoiGraph& local, const LocalEdges& edges) {
    std::vector<std::uint8_t> isRim(local.edges.size());
    std::vector<std::uint32_t> entry;  // the local vertex behind each rim edge
    for (const VoronoiEdge& rim : hole.rim) {
      const auto it =
          std::lower_bound(edges.begin(), edges.end(), LocalEdges::value_type{keyOf(rim), 0});
      if (it == edges.end() || it->first != keyOf(rim)) return false;
      const VoronoiEdge& edge = local.edges[it->second];
      isRim[it->second] = 1;
      entry.push_back(edge.left == rim.left ? edge.target : edge.source);
      if (entry.back() == VoronoiEdge::kNoVertex) return false;
    }
    const std::vector<std::uint32_t> newOf = addInner(local, isRim, entry);
    for (std::size_t e = 0; e < local.edges.size(); ++e) {
      VoronoiEdge edge = local.edges[e];
      if (isRim[e] || newOf[edge.source] == VoronoiEdge::kNoVertex) continue;
      if (edge.isInfinite()) return false;
      edge.source = newOf[edge.source];
      edge.target = newOf[edge.target];
      result_.edges.push_back(edge);
    }
    for (std::size_t i = 0; i < entry.size(); ++i) addRim(hole.rim[i], newOf[entry[i]]);
    return true;
  }

  /** Adds the local vertices inside of the hole; returns their new numbers. */
  std::vector<std::uint32_t> addInner(const VoronoiGraph& local,
                                      const std::vector<std::uint8_t>& isRim,
                                      const std::vector<std::uint32_t>& entry) {
    UnionFind groups(local.vertices.size());
    for (std::size_t e = 0; e < local.edges.size(); ++e)
      if (!isRim[e] && !local.edges[e].isInfinite())
        groups.join(local.edges[e].source, local.edges[e].target);
    std::vector<std::uint8_t> isInner(local.vertices.size());
    for (const auto v : entry) isInner[groups.find(v)] = 1;
    std::vector<std::uint32_t> newOf(local.vertices.size(), VoronoiEdge::kNoVertex);
    for (std::uint32_t v = 0; v < newOf.size(); ++v) {
      if (!isInner[groups.find(v)]) continue;
      newOf[v] = std::uint32_t(result_.vertices.size());
      result_.vertices.push_back(local.vertices[v]);
    }
    return newOf;
  }

  void addRim(VoronoiEdge edge, std::uint32_t inner) {
    const Point p = graph_.obstacles[edge.left], q = graph_.obstacles[edge.right];
    edge.target = inner;
    if (edge.source == VoronoiEdge::kNoVertex) {  // from infinity: edges start at a vertex
      edge = flip(edge);
      edge.minClearance = rayClearance(q, p, result_.vertices[inner]);
    } else {
      edge.source = newOf_[edge.source];
      edge.minClearance =
          edgeClearance(p, q, result_.vertices[edge.source], result_.vertices[inner]);
    }
    result_.edges.push_back(edge);
  }

  const VoronoiGraph& graph_;
  const ObstacleCells& obstacles_;
  const std::vector<std::uint8_t>& isLeftOut_;
  std::vector<std::uint8_t> goes_;    // per vertex
  std::vector<VoronoiEdge> atHoles_;  // with an end that goes
  std::vector<std::uint32_t> newOf_;
  VoronoiGraph result_;
};

VoronoiGraph fromScratch(const VoronoiGraph& graph, const ObstacleCells& obstacles,
                         const std::vector<std::uint8_t>& isLeftOut) {
  ObstacleCells kept{obstacles.frame, {}};
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < obstacles.cells.size(); ++i) {
    if (isLeftOut[i]) continue;
    kept.cells.push_back(obstacles.cells[i]);
    numbers.push_back(i);
  }
  VoronoiGraph result = voronoiGraph(kept);
  for (VoronoiEdge& edge : result.edges) {
    edge.left = numbers[edge.left];
    edge.right = numbers[edge.right];
  }
  result.obstacles = graph.obstacles;
  return result;
}

}  // namespace

VoronoiGraph voronoiWithout(const VoronoiGraph& graph, const ObstacleCells& obstacles,
                            const std::vector<std::uint8_t>& isLeftOut) {
  auto filled = HoleFiller(graph, obstacles, isLeftOut).run();
  return filled ? std::move(*filled) : fromScratch(graph, obstacles, isLeftOut);
}

}  // namespace roomgraph
