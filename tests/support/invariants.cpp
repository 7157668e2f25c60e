#include "invariants.h"

#include <algorithm>
#include <cmath>

namespace roomgraph::test {
namespace {

constexpr double kTolerance = 1e-9;  // [m], for sums that were rounded along different ways

class Checker {
 public:
  Checker(const TopologyGraph& graph, double clearance) : graph_(graph), clearance_(clearance) {}

  std::vector<std::string> run() {
    for (std::size_t v = 0; v < graph_.vertices().size(); ++v) checkVertex(VertexId(v));
    for (std::size_t e = 0; e < graph_.edges().size(); ++e) checkEdge(EdgeId(e));
    checkCrossings();
    return std::move(broken_);
  }

 private:
  void expect(bool isTrue, const std::string& what, std::size_t id) {
    if (!isTrue) broken_.push_back(what + " (" + std::to_string(id) + ")");
  }

  void checkVertex(VertexId v) {
    const Vertex& vertex = graph_.vertex(v);
    expect(std::isfinite(vertex.place.x) && std::isfinite(vertex.place.y), "vertex is nowhere",
           v.index());
    expect(vertex.kind != VertexKind::deadEnd || graph_.degree(v) == 1, "dead end has not one way",
           v.index());
    for (const HalfEdgeId h : graph_.outgoing(v))
      expect(graph_.source(h) == v && graph_.target(TopologyGraph::twin(h)) == v,
             "half edge and twin disagree", h.index());
  }

  void checkEdge(EdgeId e) {
    const Edge& edge = graph_.edge(e);
    const Path& path = edge.path;
    expect(path.points.size() >= 2, "path has fewer than two points", e.index());
    expect(!path.points.empty() && path.points.front() == graph_.vertex(edge.source).place,
           "path does not start at its source", e.index());
    expect(!path.points.empty() && path.points.back() == graph_.vertex(edge.target).place,
           "path does not end at its target", e.index());
    expect(std::abs(length(path.points) - path.length) <= kTolerance * (1 + path.length),
           "path length is not the sum of its segments", e.index());
    if (path.obstacles.empty()) return;
    expect(path.obstacles.size() + 1 == path.points.size(), "obstacles and segments differ",
           e.index());
    expect(path.minClearance >= clearance_ - kTolerance, "path comes too near to an obstacle",
           e.index());
  }

  struct Segment {
    Point a, b;
    std::size_t edge;
  };

  void checkCrossings() {
    std::vector<Segment> segments;
    for (std::size_t e = 0; e < graph_.edges().size(); ++e) {
      const Polyline& points = graph_.edges()[e].path.points;
      for (std::size_t i = 1; i < points.size(); ++i)
        segments.push_back({points[i - 1], points[i], e});
    }
    const auto left = [](const Segment& s) { return std::min(s.a.x, s.b.x); };
    const auto right = [](const Segment& s) { return std::max(s.a.x, s.b.x); };
    std::sort(segments.begin(), segments.end(),
              [&](const Segment& s, const Segment& t) { return left(s) < left(t); });
    std::vector<const Segment*> open;
    for (const Segment& segment : segments) {
      open.erase(std::remove_if(open.begin(), open.end(),
                                [&](const Segment* s) { return right(*s) < left(segment); }),
                 open.end());
      for (const Segment* other : open)
        if (properlyCross(*other, segment))
          expect(false, "path crosses path " + std::to_string(other->edge), segment.edge);
      open.push_back(&segment);
    }
  }

  /** Each has the ends of the other on its two sides, by more than rounding. */
  static bool properlyCross(const Segment& s, const Segment& t) {
    const auto side = [](Point a, Point b, Point p) {
      const double area = cross(b - a, p - a);
      return std::abs(area) <= kTolerance * distance(a, b) ? 0 : area > 0 ? 1 : -1;
    };
    return side(s.a, s.b, t.a) * side(s.a, s.b, t.b) < 0 &&
           side(t.a, t.b, s.a) * side(t.a, t.b, s.b) < 0;
  }

  const TopologyGraph& graph_;
  double clearance_;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> brokenInvariants(const TopologyGraph& graph, double clearance) {
  return Checker(graph, clearance).run();
}

}  // namespace roomgraph::test
