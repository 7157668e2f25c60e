#include "brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "blocked.h"
#include "invariants.h"
#include "roomgraph/base/UnionFind.h"

namespace roomgraph::test {
namespace {

class PromiseChecker {
 public:
  explicit PromiseChecker(const Stages& stages) : s_(stages) {
    outsideIsBlocked_ = std::find(s_.grid.cells.begin(), s_.grid.cells.end(), State::unknown) !=
                        s_.grid.cells.end();
  }

  std::vector<std::string> run() {
    check("topology", s_.topology);
    check("pruned", s_.pruned);
    check("joined up", s_.joinedUp);
    check("kept", s_.kept);
    check("cut", s_.cut);
    check("cleaned", s_.cleaned);
    check("doors", s_.doors);
    check("result", s_.result.graph);
    checkComponents();
    checkRooms();
    return std::move(broken_);
  }

 private:
  void tell(const std::string& what) {
    if (broken_.size() < 20) broken_.push_back(what);
  }

  void check(const std::string& stage, const TopologyGraph& graph) {
    for (const std::string& broken : brokenInvariants(graph, s_.clearance))
      tell(stage + ": " + broken);
    for (std::size_t h = 0; h < 2 * graph.edges().size(); ++h)
      checkTwins(stage, graph, HalfEdgeId(h));
    for (const Edge& edge : graph.edges()) checkPath(stage, edge);
    for (const Vertex& vertex : graph.vertices()) checkVertex(stage, vertex);
  }

  void checkTwins(const std::string& stage, const TopologyGraph& graph, HalfEdgeId h) {
    const HalfEdgeId twin = TopologyGraph::twin(h);
    Path back = graph.halfPath(twin);
    std::reverse(back.points.begin(), back.points.end());
    const auto out = graph.outgoing(graph.source(h));
    if (twin == h || TopologyGraph::twin(twin) != h || graph.source(twin) != graph.target(h) ||
        graph.halfPath(h).points != back.points || std::count(out.begin(), out.end(), h) != 1)
      tell(stage + ": twins disagree at half edge " + std::to_string(h.index()));
  }

  void checkVertex(const std::string& stage, const Vertex& vertex) {
    const double found = distanceToBlocked(s_.grid, outsideIsBlocked_, vertex.place,
                                           vertex.clearance + s_.grid.frame.resolution);
    if (std::abs(found - vertex.clearance) > 1e-6)
      tell(stage + ": vertex claims clearance " + std::to_string(vertex.clearance) + " and has " +
           std::to_string(found) + textOf(vertex.place));
  }

  void checkPath(const std::string& stage, const Edge& edge) {
    const Polyline& points = edge.path.points;
    const double step = s_.grid.frame.resolution / 4;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const int count = 1 + int(distance(points[i], points[i + 1]) / step);
      for (int k = 0; k <= count; ++k)
        if (!checkPlace(stage, points[i] + (double(k) / count) * (points[i + 1] - points[i])))
          return;
    }
  }

  bool checkPlace(const std::string& stage, Point p) {
    if (!s_.grid.isFree(p)) {
      tell(stage + ": path runs through a cell that is not free" + textOf(p));
      return false;
    }
    const double found = distanceToBlocked(s_.grid, outsideIsBlocked_, p, s_.clearance);
    if (found >= s_.clearance - 1e-9) return true;
    tell(stage + ": path comes as near as " + std::to_string(found) + textOf(p));
    return false;
  }

  void checkComponents() {
    const std::size_t count = componentCount(s_.topology);
    if (componentCount(s_.pruned) != count) tell("pruning changed the connected parts");
    if (componentCount(s_.joinedUp) != count) tell("joining changed the connected parts");
    const std::size_t kept = componentCount(s_.kept);
    if (s_.options.keepComponents.onlyLargest && kept > 1) tell("more than the largest part kept");
    for (const auto* graph : {&s_.cut, &s_.cleaned, &s_.doors})
      if (componentCount(*graph) != kept) tell("cutting rooms changed the connected parts");
    if (componentCount(s_.result.graph) > kept) tell("the result has more parts than the graph");
  }

  void checkRooms() {
    for (std::size_t r = 0; r < s_.result.rooms.size(); ++r) {
      const GraphRoom& room = s_.result.rooms[r];
      const Vertex& vertex = s_.result.graph.vertex(room.vertex);
      if (vertex.kind != VertexKind::room || vertex.room != RoomId(r))
        tell("room and vertex disagree" + textOf(vertex.place));
      if (sideOf(room.shape.polygon, room.center) != Side::inside)
        tell("room vertex is not inside of its room" + textOf(room.center));
      if (area(room.shape.polygon) <= 0) tell("room has no area" + textOf(room.center));
      checkWays(room, RoomId(r));
      for (const VertexId v : room.borderVertices) checkBorder(room, s_.result.graph.vertex(v));
    }
  }

  /** From the room's vertex, its ways lead to all its border vertices. */
  void checkWays(const GraphRoom& room, RoomId id) {
    const TopologyGraph& graph = s_.result.graph;
    UnionFind groups(graph.vertices().size());
    for (const Edge& edge : graph.edges())
      if (edge.room == id)
        groups.join(std::uint32_t(edge.source.index()), std::uint32_t(edge.target.index()));
    for (const VertexId v : room.borderVertices)
      if (groups.find(std::uint32_t(v.index())) != groups.find(std::uint32_t(room.vertex.index())))
        tell("a border vertex is not reached from its room" + textOf(graph.vertex(v).place));
  }

  void checkBorder(const GraphRoom& room, const Vertex& border) {
    if (border.kind != VertexKind::border)
      tell("room lists what borders nothing" + textOf(border.place));
    double nearest = std::numeric_limits<double>::infinity();
    forEachEdge(room.shape.polygon, [&](Point a, Point b) {
      nearest = std::min(nearest, distanceToSegment(border.place, a, b));
    });
    const double most = s_.roomRadius > 0 ? s_.options.joinDoors.maxDepth / 2 : 0;
    if (nearest > most + 1e-6)
      tell("border vertex is " + std::to_string(nearest) + " m off its room" +
           textOf(border.place));
  }

  const Stages& s_;
  bool outsideIsBlocked_ = false;
  std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> brokenPromises(const Stages& stages) {
  return PromiseChecker(stages).run();
}

std::size_t componentCount(const TopologyGraph& graph) {
  UnionFind groups(graph.vertices().size());
  std::size_t count = graph.vertices().size();
  for (const Edge& edge : graph.edges())
    count -= groups.join(std::uint32_t(edge.source.index()), std::uint32_t(edge.target.index()));
  return count;
}

}  // namespace roomgraph::test
