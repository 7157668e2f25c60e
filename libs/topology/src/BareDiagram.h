#pragma once
#include <boost/polygon/voronoi.hpp>
#include <cstddef>
#include <cstdint>

namespace roomgraph {

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

}  // namespace roomgraph
