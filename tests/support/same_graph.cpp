#include "same_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace roomgraph::test {
namespace {

double distanceToLine(Point p, const Polyline& line) {
  double nearest = distance(p, line.front());
  for (std::size_t i = 1; i < line.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(p, line[i - 1], line[i]));
  return nearest;
}

double farthest(const Polyline& from, const Polyline& to) {
  double worst = 0;
  for (const Point p : from) worst = std::max(worst, distanceToLine(p, to));
  return worst;
}

class Matcher {
 public:
  Matcher(const RoomGraph& a, const RoomGraph& b, const std::function<Point(Point)>& aToB,
          double tolerance)
      : a_(a), b_(b), aToB_(aToB), tolerance_(tolerance) {}

  std::string run() {
    std::string difference = matchVertices();
    if (difference.empty()) difference = matchEdges();
    if (difference.empty()) difference = matchRooms();
    return difference;
  }

 private:
  static std::string text(const char* what, std::size_t index, Point at, double off) {
    std::ostringstream out;
    out << what << " " << index << " at (" << at.x << ", " << at.y << "), best is off by " << off;
    return out.str();
  }

  /** A ring vertex may stand anywhere on its ring: how far it is from the other's path. */
  double offset(const Vertex& va, VertexId v) const {
    const Point at = aToB_(va.place);
    if (va.kind != VertexKind::ring) return distance(at, b_.graph.vertex(v).place);
    double nearest = std::numeric_limits<double>::infinity();
    for (const HalfEdgeId h : b_.graph.outgoing(v))
      nearest = std::min(nearest, distanceToLine(at, b_.graph.edge(h).path.points));
    return nearest;
  }

  std::string matchVertices() {
    const auto& as = a_.graph.vertices();
    const auto& bs = b_.graph.vertices();
    if (as.size() != bs.size())
      return std::to_string(as.size()) + " and " + std::to_string(bs.size()) + " vertices";
    std::vector<bool> isTaken(bs.size());
    for (const Vertex& va : as) {
      double best = std::numeric_limits<double>::infinity();
      VertexId partner;
      for (std::size_t v = 0; v < bs.size(); ++v) {
        if (isTaken[v] || bs[v].kind != va.kind || offset(va, VertexId(v)) >= best) continue;
        partner = VertexId(v);
        best = offset(va, partner);
      }
      // Inner places of a concave room may change along flat paths; its polygon is compared.
      const double limit = va.kind == VertexKind::room ? 2 * tolerance_ : tolerance_;
      if (best > limit)
        return text("no partner for vertex", partnerOf_.size(), aToB_(va.place), best);
      isTaken[partner.index()] = true;
      partnerOf_.push_back(partner);
    }
    return {};
  }

  double offset(const Edge& ea, const Edge& eb) const {
    const VertexId source = partnerOf_[ea.source.index()], target = partnerOf_[ea.target.index()];
    const bool sameEnds = (eb.source == source && eb.target == target) ||
                          (eb.source == target && eb.target == source);
    if (!sameEnds || bool(ea.room) != bool(eb.room)) return std::numeric_limits<double>::infinity();
    if (ea.room) return 0;
    Polyline mapped;
    for (const Point p : ea.path.points) mapped.push_back(aToB_(p));
    return std::max(farthest(mapped, eb.path.points), farthest(eb.path.points, mapped));
  }

  std::string matchEdges() const {
    const auto& as = a_.graph.edges();
    const auto& bs = b_.graph.edges();
    if (as.size() != bs.size())
      return std::to_string(as.size()) + " and " + std::to_string(bs.size()) + " edges";
    std::vector<bool> isTaken(bs.size());
    for (std::size_t e = 0; e < as.size(); ++e) {
      double best = std::numeric_limits<double>::infinity();
      std::size_t partner = 0;
      for (std::size_t f = 0; f < bs.size(); ++f) {
        if (isTaken[f] || offset(as[e], bs[f]) >= best) continue;
        partner = f;
        best = offset(as[e], bs[f]);
      }
      if (best > tolerance_)
        return text("no partner for edge", e, aToB_(as[e].path.points.front()), best);
      isTaken[partner] = true;
    }
    return {};
  }

  std::string matchRooms() const {
    if (a_.rooms.size() != b_.rooms.size()) return "different numbers of rooms";
    for (const GraphRoom& room : a_.rooms) {
      const auto partner = std::find_if(
          b_.rooms.begin(), b_.rooms.end(),
          [&](const GraphRoom& other) { return other.vertex == partnerOf_[room.vertex.index()]; });
      if (partner == b_.rooms.end()) return "a room has no partner";
      std::vector<VertexId> borders;
      for (const VertexId v : room.borderVertices) borders.push_back(partnerOf_[v.index()]);
      std::sort(borders.begin(), borders.end());
      if (borders != partner->borderVertices) return "the border vertices of a room differ";
      if (room.shape.polygon.holes.size() != partner->shape.polygon.holes.size())
        return "the holes of a room differ";
      // The walls may move by half of the tolerance all round.
      const double areaA = area(room.shape.polygon), areaB = area(partner->shape.polygon);
      const double rim = tolerance_ * perimeter(room.shape.polygon) / 2;
      if (std::abs(areaA - areaB) > rim) return text("area of room", 0, room.center, areaA - areaB);
    }
    return {};
  }

  static double perimeter(const Polygon& polygon) {
    double sum = length(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += length(hole);
    return sum;
  }

  const RoomGraph& a_;
  const RoomGraph& b_;
  const std::function<Point(Point)>& aToB_;
  double tolerance_;
  std::vector<VertexId> partnerOf_;
};

}  // namespace

std::string differenceOfGraphs(const RoomGraph& a, const RoomGraph& b,
                               const std::function<Point(Point)>& aToB, double tolerance) {
  return Matcher(a, b, aToB, tolerance).run();
}

}  // namespace roomgraph::test
