#include "graph_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomgraph::test {
namespace {

double distanceToRings(Point p, const Polygon& polygon) {
  double nearest = std::numeric_limits<double>::infinity();
  forEachEdge(polygon,
              [&](Point a, Point b) { nearest = std::min(nearest, distanceToSegment(p, a, b)); });
  return nearest;
}

class Rules {
 public:
  explicit Rules(const Stages& stages) : s_(stages), graph_(stages.result.graph) {
    // Coordinates far from the origin are rounded.
    const Point at = s_.grid.frame.origin;
    near_ = 1e-6 + 1e-9 * (std::abs(at.x) + std::abs(at.y));
  }

  std::vector<std::string> broken() {
    for (std::size_t e = 0; e < graph_.edges().size(); ++e) checkEdge(e);
    for (std::size_t v = 0; v < graph_.vertices().size(); ++v) checkVertex(v);
    for (std::size_t r = 0; r < s_.result.rooms.size(); ++r) checkRoom(r);
    return std::move(broken_);
  }

 private:
  void expect(bool isTrue, const std::string& what, std::size_t id) {
    if (!isTrue) broken_.push_back(what + " (" + std::to_string(id) + ")");
  }

  void checkEdge(std::size_t e) {
    const Edge& edge = graph_.edges()[e];
    const Polyline& points = edge.path.points;
    if (points.size() < 2) return expect(false, "path has fewer than two points", e);
    const Vertex &source = graph_.vertex(edge.source), &target = graph_.vertex(edge.target);
    expect(points.front() == source.place && points.back() == target.place,
           "path does not end on its vertices", e);
    expect(std::abs(length(points) - edge.path.length) <= near_ * double(points.size()),
           "length is not that of the path", e);
  }

  void checkVertex(std::size_t v) {
    const Vertex& vertex = graph_.vertices()[v];
    expect(std::isfinite(vertex.place.x) && std::isfinite(vertex.place.y), "vertex is nowhere", v);
    const bool needsRoom = vertex.kind == VertexKind::room || vertex.kind == VertexKind::border;
    expect(!needsRoom || vertex.room, "room or border vertex has no room", v);
  }

  void checkRoom(std::size_t r) {
    const GraphRoom& room = s_.result.rooms[r];
    expect(room.shape.polygon.outer.size() >= 3, "polygon has fewer than three corners", r);
    const double size = area(room.shape.polygon);
    const double before = r > 0 ? area(s_.result.rooms[r - 1].shape.polygon) : size;
    expect(size <= before + near_ * (1 + before), "room is larger than the one before it", r);
    for (const VertexId v : room.borderVertices) {
      expect(graph_.vertex(v).kind == VertexKind::border, "room lists what borders nothing", r);
      const double off = distanceToRings(graph_.vertex(v).place, room.shape.polygon);
      const double most =
          s_.roomRadius > 0 && isDoorOfTwo(v) ? s_.options.joinDoors.maxDepth / 2 : 0;
      expect(off <= most + near_, "border vertex lies " + std::to_string(off) + " m off its room",
             v.index());
    }
  }

  bool isDoorOfTwo(VertexId v) const {
    const auto& rooms = s_.result.rooms;
    return std::count_if(rooms.begin(), rooms.end(), [&](const GraphRoom& room) {
             return std::binary_search(room.borderVertices.begin(), room.borderVertices.end(), v);
           }) == 2;
  }

  const Stages& s_;
  const TopologyGraph& graph_;
  double near_ = 0;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> brokenRules(const Stages& stages) { return Rules(stages).broken(); }

}  // namespace roomgraph::test
