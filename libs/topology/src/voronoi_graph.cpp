#include "roomgraph/topology/voronoi_graph.h"

#include <boost/polygon/voronoi.hpp>
#include <cstddef>
#include <cstdint>

#include "edge_clearance.h"

// Boost takes cells as they are: it only has to find their coordinates.
template <>
struct boost::polygon::geometry_concept<roomgraph::Cell> {
  using type = boost::polygon::point_concept;
};
template <>
struct boost::polygon::point_traits<roomgraph::Cell> {
  using coordinate_type = int;
  static int get(const roomgraph::Cell& cell, const boost::polygon::orientation_2d& axis) {
    return axis == boost::polygon::HORIZONTAL ? cell.x : cell.y;
  }
};

namespace roomgraph {
namespace {

// Boost's diagram of points with nothing in it but what it is built with. Its own cells, vertices
// and edges have a colour each, and tell what kind of generator or curve they are of: a fifth of
// the memory.

class BareEdge;

class BareCell {
 public:
  BareCell(std::size_t source, boost::polygon::SourceCategory)
      : source_(static_cast<std::uint32_t>(source)) {}

  std::size_t source_index() const { return source_; }
  bool is_degenerate() const { return incident_ == nullptr; }
  BareEdge* incident_edge() const { return incident_; }
  void incident_edge(BareEdge* edge) { incident_ = edge; }

 private:
  BareEdge* incident_ = nullptr;
  std::uint32_t source_;
};

class BareVertex {
 public:
  BareVertex(double x, double y) : x_(x), y_(y) {}

  double x() const { return x_; }
  double y() const { return y_; }
  BareEdge* incident_edge() const { return incident_; }
  void incident_edge(BareEdge* edge) { incident_ = edge; }

 private:
  double x_, y_;
  BareEdge* incident_ = nullptr;
};

/** Boost keeps twins side by side, so that one bit tells where the twin is. */
class BareEdge {
 public:
  BareEdge(bool /*isLinear*/, bool /*isPrimary*/) {}

  BareCell* cell() const { return reinterpret_cast<BareCell*>(cellAndSide_ & ~kSecond); }
  void cell(BareCell* cell) {
    cellAndSide_ = reinterpret_cast<std::uintptr_t>(cell) | (cellAndSide_ & kSecond);
  }
  BareVertex* vertex0() const { return vertex_; }
  void vertex0(BareVertex* vertex) { vertex_ = vertex; }
  BareVertex* vertex1() const { return twin()->vertex_; }
  BareEdge* twin() { return this + sideOfTwin(); }
  const BareEdge* twin() const { return this + sideOfTwin(); }
  void twin(const BareEdge* edge) {
    cellAndSide_ = (cellAndSide_ & ~kSecond) | (edge < this ? kSecond : 0);
  }
  BareEdge* next() const { return next_; }
  void next(BareEdge* edge) { next_ = edge; }
  BareEdge* prev() const { return prev_; }
  void prev(BareEdge* edge) { prev_ = edge; }
  BareEdge* rot_next() const { return prev_->twin(); }
  BareEdge* rot_prev() const { return twin()->next_; }

 private:
  static constexpr std::uintptr_t kSecond = 1;  // of the two; no cell has an odd address

  std::ptrdiff_t sideOfTwin() const { return cellAndSide_ & kSecond ? -1 : 1; }

  std::uintptr_t cellAndSide_ = 0;
  BareVertex* vertex_ = nullptr;
  BareEdge *next_ = nullptr, *prev_ = nullptr;
};

struct BareTraits {
  using coordinate_type = double;
  using cell_type = BareCell;
  using vertex_type = BareVertex;
  using edge_type = BareEdge;
  /** Boost's own. */
  struct vertex_equality_predicate_type {
    bool operator()(const BareVertex& a, const BareVertex& b) const {
      constexpr unsigned kUlps = 128;
      using Compare = boost::polygon::detail::ulp_comparison<double>;
      return Compare()(a.x(), b.x(), kUlps) == Compare::EQUAL &&
             Compare()(a.y(), b.y(), kUlps) == Compare::EQUAL;
    }
  };
};

using BareDiagram = boost::polygon::voronoi_diagram<double, BareTraits>;

class Converter {
 public:
  Converter(const ObstacleCells& obstacles, const BareDiagram& diagram)
      : frame_(obstacles.frame), diagram_(diagram) {
    graph_.obstacles.reserve(obstacles.cells.size());
    for (const Cell cell : obstacles.cells) graph_.obstacles.push_back(frame_.center(cell));
    graph_.vertices.reserve(diagram.num_vertices());
    graph_.edges.reserve(diagram.num_edges() / 2);
  }

  VoronoiGraph run() {
    for (const auto& vertex : diagram_.vertices()) addVertex(vertex);
    const auto& edges = diagram_.edges();
    // Twins stand side by side: every second edge is one of each pair.
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) addEdge(edges[i]);
    return std::move(graph_);
  }

 private:
  void addVertex(const BareVertex& vertex) {
    const Point at{frame_.origin.x + (vertex.x() + 0.5) * frame_.resolution,
                   frame_.origin.y + (vertex.y() + 0.5) * frame_.resolution};
    const auto obstacle = vertex.incident_edge()->cell()->source_index();
    graph_.vertices.push_back({at, distance(at, graph_.obstacles[obstacle])});
  }

  void addEdge(const BareEdge& boostEdge) {
    const auto* edge = boostEdge.vertex0() ? &boostEdge : boostEdge.twin();
    if (!edge->vertex0()) return;
    VoronoiEdge result;
    result.source = indexOf(edge->vertex0());
    result.left = std::uint32_t(edge->cell()->source_index());
    result.right = std::uint32_t(edge->twin()->cell()->source_index());
    const Point p = graph_.obstacles[result.left], q = graph_.obstacles[result.right];
    const VoronoiVertex& source = graph_.vertices[result.source];
    if (edge->vertex1()) {
      result.target = indexOf(edge->vertex1());
      const VoronoiVertex& target = graph_.vertices[result.target];
      result.minClearance = edgeClearance(p, q, source, target);
    } else {
      result.minClearance = rayClearance(p, q, source);
    }
    graph_.edges.push_back(result);
  }

  std::uint32_t indexOf(const BareVertex* vertex) const {
    return std::uint32_t(vertex - diagram_.vertices().data());
  }

  GridFrame frame_;
  const BareDiagram& diagram_;
  VoronoiGraph graph_;
};

}  // namespace

VoronoiGraph voronoiGraph(const ObstacleCells& obstacles) {
  BareDiagram diagram;
  boost::polygon::construct_voronoi(obstacles.cells.begin(), obstacles.cells.end(), &diagram);
  return Converter(obstacles, diagram).run();
}

}  // namespace roomgraph
