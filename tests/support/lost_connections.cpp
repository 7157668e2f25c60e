#include <algorithm>
#include <limits>
#include <set>

#include "blocked.h"
#include "brute_force.h"
#include "roomgraph/base/UnionFind.h"

namespace roomgraph::test {
namespace {

/** Where the way straight away from the nearest obstacle leads to, Voronoi vertex by vertex. */
class Climber {
 public:
  explicit Climber(const Stages& stages)
      : s_(stages),
        edgesOfObstacle_(stages.voronoi.obstacles.size()),
        obstacleAt_(paddedCount(), kNone) {
    for (std::uint32_t e = 0; e < s_.voronoi.edges.size(); ++e)
      for (const auto obstacle : {s_.voronoi.edges[e].left, s_.voronoi.edges[e].right})
        edgesOfObstacle_[obstacle].push_back(e);
    for (std::uint32_t i = 0; i < s_.obstacles.cells.size(); ++i)
      obstacleAt_[paddedIndex(s_.obstacles.cells[i])] = i;
  }

  /** The Voronoi vertex reached from `p`: first straight away from the nearest obstacle to an edge
   *  of its cell, then along that edge away from both of its obstacles; none where that never
   *  ends. */
  std::uint32_t vertexFrom(Point p) const {
    const std::uint32_t obstacle = nearestObstacle(p);
    const Point from = s_.voronoi.obstacles[obstacle], ahead = p - from;
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t best = kNone;
    for (const auto e : edgesOfObstacle_[obstacle]) {
      const auto [a, b] = endsOf(s_.voronoi.edges[e]);
      const double turn = cross(ahead, b - a);
      if (turn == 0) continue;
      // from + along * ahead is a + across * (b - a)
      const double along = cross(a - from, b - a) / turn, across = cross(a - from, ahead) / turn;
      if (along < 1 - 1e-9 || across < -1e-9 || across > 1 + 1e-9 || along >= nearest) continue;
      nearest = along;
      best = upperEnd(s_.voronoi.edges[e], from + along * ahead);
    }
    return best;
  }

 private:
  static constexpr std::uint32_t kNone = VoronoiEdge::kNoVertex;

  std::pair<Point, Point> endsOf(const VoronoiEdge& edge) const {
    const Point a = s_.voronoi.vertices[edge.source].place;
    if (!edge.isInfinite()) return {a, s_.voronoi.vertices[edge.target].place};
    const Point left = s_.voronoi.obstacles[edge.left], right = s_.voronoi.obstacles[edge.right];
    constexpr double far = 1e6;
    return {a, a + far * Point{left.y - right.y, right.x - left.x}};
  }

  std::uint32_t upperEnd(const VoronoiEdge& edge, Point at) const {
    const Point between =
        midpoint(s_.voronoi.obstacles[edge.left], s_.voronoi.obstacles[edge.right]);
    const auto [a, b] = endsOf(edge);
    return dot(b - a, at - between) >= 0 ? edge.target : edge.source;
  }

  std::size_t paddedCount() const {
    const GridFrame& frame = s_.grid.frame;
    return std::size_t(frame.width + 2) * std::size_t(frame.height + 2);
  }
  std::size_t paddedIndex(Cell c) const {
    return std::size_t(c.y + 1) * std::size_t(s_.grid.frame.width + 2) + std::size_t(c.x + 1);
  }

  /** In a square that grows until it must hold the nearest. */
  std::uint32_t nearestObstacle(Point p) const {
    const GridFrame& frame = s_.grid.frame;
    const Cell middle = frame.cellAt(p);
    for (int reach = 2;; reach *= 2) {
      std::uint32_t best = kNone;
      double nearest = (reach - 1) * frame.resolution;
      for (int y = std::max(-1, middle.y - reach); y <= std::min(frame.height, middle.y + reach);
           ++y)
        for (int x = std::max(-1, middle.x - reach); x <= std::min(frame.width, middle.x + reach);
             ++x) {
          const std::uint32_t obstacle = obstacleAt_[paddedIndex({x, y})];
          if (obstacle == kNone || distance(s_.voronoi.obstacles[obstacle], p) >= nearest) continue;
          nearest = distance(s_.voronoi.obstacles[obstacle], p);
          best = obstacle;
        }
      if (best != kNone) return best;
    }
  }

  const Stages& s_;
  std::vector<std::vector<std::uint32_t>> edgesOfObstacle_;
  std::vector<std::uint32_t> obstacleAt_;  // by cell, with the ring outside of the grid
};

/** Places on a fine raster, and which of them a disc can travel between. */
class FloodFill {
 public:
  FloodFill(const Stages& stages, int samplesPerCell)
      : s_(stages),
        width_(stages.grid.frame.width * samplesPerCell),
        height_(stages.grid.frame.height * samplesPerCell),
        spacing_(stages.grid.frame.resolution / samplesPerCell),
        isOpen_(std::size_t(width_) * std::size_t(height_)),
        groups_(isOpen_.size()) {
    // Between two neighbouring places the disc comes nearer by at most half of their distance.
    const double wanted = s_.clearance + spacing_ / 2 + 1e-9;
    const bool outsideIsBlocked = isBlockedOutside(s_.grid);
    for (std::uint32_t i = 0; i < isOpen_.size(); ++i)
      isOpen_[i] = s_.grid.isFree(place(i)) &&
                   distanceToBlocked(s_.grid, outsideIsBlocked, place(i), wanted) >= wanted;
    for (std::uint32_t i = 0; i < isOpen_.size(); ++i) {
      const bool hasRight = (i + 1) % std::uint32_t(width_) != 0;
      if (isOpen_[i] && hasRight && isOpen_[i + 1]) groups_.join(i, i + 1);
      const std::uint32_t above = i + std::uint32_t(width_);
      if (isOpen_[i] && above < isOpen_.size() && isOpen_[above]) groups_.join(i, above);
    }
  }

  std::uint32_t count() const { return std::uint32_t(isOpen_.size()); }
  bool isOpen(std::uint32_t i) const { return isOpen_[i]; }
  std::uint32_t group(std::uint32_t i) { return groups_.find(i); }
  Point place(std::uint32_t i) const {
    const auto w = std::uint32_t(width_);
    return s_.grid.frame.origin + Point{(i % w + 0.5) * spacing_, (i / w + 0.5) * spacing_};
  }

 private:
  const Stages& s_;
  int width_, height_;
  double spacing_;
  std::vector<bool> isOpen_;
  UnionFind groups_;
};

}  // namespace

std::vector<std::string> lostConnections(const Stages& stages, int samplesPerCell) {
  if (stages.obstacles.cells.size() < 2) return {};
  const Climber climber(stages);
  FloodFill fill(stages, samplesPerCell);
  UnionFind parts(stages.voronoi.vertices.size());
  for (const auto e : stages.clearEdges)
    parts.join(stages.voronoi.edges[e].source, stages.voronoi.edges[e].target);
  std::vector<std::uint32_t> partOf(fill.count(), VoronoiEdge::kNoVertex);
  std::set<std::string> lost;
  for (std::uint32_t i = 0; i < fill.count(); ++i) {
    if (!fill.isOpen(i)) continue;
    const std::uint32_t vertex = climber.vertexFrom(fill.place(i));
    if (vertex == VoronoiEdge::kNoVertex || !stages.isInside[vertex]) {
      lost.insert("a free place has no vertex" + textOf(fill.place(i)));
      continue;
    }
    std::uint32_t& part = partOf[fill.group(i)];
    if (part == VoronoiEdge::kNoVertex) part = parts.find(vertex);
    if (part != parts.find(vertex))
      lost.insert("connected places lie in unconnected parts" + textOf(fill.place(i)));
  }
  return {lost.begin(), lost.end()};
}

}  // namespace roomgraph::test
