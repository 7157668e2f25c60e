#include "drawn_pose_graph.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph::test {
namespace {

constexpr double kLong = 20, kShort = 10, kNear = 2;

/** The pose at `s` metres round the block. */
Transform2D poseAt(double s) {
  Transform2D corner;
  for (double side = kLong; s >= side; side = side == kLong ? kShort : kLong) {
    corner = corner * Transform2D{side, 0, M_PI / 2};
    s -= side;
  }
  return corner * Transform2D{s, 0, 0};
}

}  // namespace

Way roundTheBlock(double offset) {
  Way way;
  for (double s = 0; s + 1 <= 2 * (kLong + kShort); ++s) way.push_back(poseAt(s + offset));
  return way;
}

Way drifting(const Way& way, double turn) {
  Way result{way.front()};
  for (std::size_t k = 1; k < way.size(); ++k)
    result.push_back(result.back() * (way[k - 1].inverse() * way[k]) * Transform2D{0, 0, turn});
  return result;
}

Way torn(const Way& way, std::size_t from, double turn, Point shift) {
  const Point at = way[from].shift();
  const Transform2D motion = carrying(at, at + shift, turn);
  Way result = way;
  for (std::size_t k = from; k < way.size(); ++k) result[k] = motion * way[k];
  return result;
}

Way scaled(Way way, double scale) {
  for (Transform2D& pose : way) pose.x *= scale, pose.y *= scale;
  return way;
}

Way moved(const Way& way, const Transform2D& motion) {
  Way result;
  for (const Transform2D& pose : way) result.push_back(motion * pose);
  return result;
}

const std::vector<Point>& drawnPoints() {
  static const std::vector<Point> points{{3, 2}, {1, 2}, {-1, 2}, {4, -1.5}, {0, -1.5}};
  return points;
}

PoseGraph drawnPoseGraph(const std::vector<Way>& drawn) {
  PointSums points;
  for (const Point point : drawnPoints()) points.add(point);
  PoseGraph graph;
  for (const Way& way : drawn) {
    graph.addRun(true);
    NodeId last;
    for (const Transform2D& pose : way) {
      const NodeId node = graph.addNode(pose, points, std::nullopt);
      if (last) graph.addLink(last, node);
      last = node;
    }
  }
  return graph;
}

PoseGraph matchedPoseGraph(const std::vector<Way>& drawn, const std::vector<Way>& truth) {
  PoseGraph graph = drawnPoseGraph(drawn);
  for (const RunId to : graph.runs.ids())
    for (const RunId from : graph.runs.ids()) {
      const Way &there = truth[from.index()], &here = truth[to.index()];
      std::vector<PoseEdge> matches;
      for (std::size_t k = 0; k < here.size() && from != to; ++k) {
        const auto nearest =
            std::min_element(there.begin(), there.end(), [&](const auto& l, const auto& r) {
              return distance(l.shift(), here[k].shift()) < distance(r.shift(), here[k].shift());
            });
        if (distance(nearest->shift(), here[k].shift()) > kNear) continue;
        const NodeId found = graph.runs[from].nodes[std::size_t(nearest - there.begin())];
        matches.push_back(
            matchEdge(found, graph.runs[to].nodes[k], nearest->inverse() * here[k], 1));
      }
      if (!matches.empty()) graph.addGroup({from, to, {}}, matches);
    }
  return graph;
}

PoseGraph withoutMatches(const PoseGraph& graph) {
  PoseGraph result = graph;
  std::vector<PoseEdge> links;
  for (const PoseEdge& edge : graph.edges)
    if (!edge.group) links.push_back(edge);
  result.groups = {};
  result.edges = ById<PoseEdgeId, PoseEdge>(std::move(links));
  return result;
}

bool joins(const MatchGroup& group, std::size_t a, std::size_t b) {
  return (group.from == RunId(a) && group.to == RunId(b)) ||
         (group.from == RunId(b) && group.to == RunId(a));
}

NodePoses posesOf(const std::vector<Way>& ways) {
  NodePoses poses;
  for (const Way& way : ways)
    for (const Transform2D& pose : way) poses.add(pose);
  return poses;
}

Way wayOf(const PoseGraph& graph, const NodePoses& poses, std::size_t run) {
  Way way;
  for (const NodeId node : graph.runs[RunId(run)].nodes) way.push_back(poses[node]);
  return way;
}

double displacement(const Way& way, const Way& truth) {
  MotionFit fit;
  for (std::size_t k = 0; k < way.size(); ++k)
    for (const Point point : drawnPoints()) fit.add(way[k](point), truth[k](point));
  const Transform2D motion = fit.motion();
  double squares = 0;
  for (std::size_t k = 0; k < way.size(); ++k)
    for (const Point point : drawnPoints())
      squares += squaredNorm(motion(way[k](point)) - truth[k](point));
  return std::sqrt(squares / fit.weight());
}

double misplaced(const Way& way, const Way& truth) {
  MotionFit fit;
  for (std::size_t k = 0; k < truth.size(); ++k) fit.add(way[k].shift(), truth[k].shift());
  const Transform2D motion = fit.motion();
  double squares = 0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    squares += squaredNorm(motion(way[k].shift()) - truth[k].shift());
  return std::sqrt(squares / fit.weight());
}

double misplaced(const NodePoses& poses, const std::vector<Way>& truth) {
  const NodePoses expected = posesOf(truth);
  return misplaced(Way(poses.begin(), poses.end()), Way(expected.begin(), expected.end()));
}

}  // namespace roomgraph::test
