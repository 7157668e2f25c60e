#include "match_graphs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <tuple>

#include "fitted_measures.h"
#include "roomgraph/geometry/NearPlaces.h"

namespace roomgraph {
namespace {

/** Where each vertex lies in the other map: once for each copy of the walls beside it. */
std::vector<std::vector<Point>> placesOf(const FollowedGraph& side, double reach) {
  const std::vector<FollowedPatch>& followed = side.followed.patches;
  std::vector<Point> middles;
  for (const FollowedPatch& f : followed) middles.push_back(side.patches[f.patch].middle);
  const NearPlaces near(middles, reach);
  std::vector<std::vector<Point>> all;
  for (const Vertex& vertex : side.graph.vertices()) {
    std::map<int, std::pair<double, std::uint32_t>> nearest;  // by layer
    near.forEachNear(vertex.place, [&](std::uint32_t i) {
      const std::pair found{distance(middles[i], vertex.place), i};
      if (found.first > reach) return;
      auto& best = nearest.try_emplace(followed[i].layer, found).first->second;
      best = std::min(best, found);
    });
    std::vector<Point>& places = all.emplace_back();
    for (const auto& [layer, found] : nearest)
      places.push_back(followed[found.second].pose(vertex.place));
    if (places.empty() && !followed.empty()) places.push_back(side.followed.pose(vertex.place));
  }
  return all;
}

double nearestOf(const std::vector<Point>& places, Point to) {
  double best = std::numeric_limits<double>::infinity();
  for (const Point p : places) best = std::min(best, distance(p, to));
  return best;
}

/** How far apart two vertices may be told to be, [i of a][k]: other vertex and distance. */
using Near = std::vector<std::vector<std::pair<std::uint32_t, double>>>;

Near nearVertices(const FollowedGraph& a, const FollowedGraph& b) {
  const auto ofA = placesOf(a, kPatchReach), ofB = placesOf(b, kPatchReach);
  Near near(ofA.size());
  for (std::uint32_t i = 0; i < ofA.size(); ++i)
    for (std::uint32_t j = 0; j < ofB.size(); ++j) {
      const double there = nearestOf(ofA[i], b.graph.vertices()[j].place);
      if (there > 2 * fitted::kMaxGrown) continue;
      const double apart = (there + nearestOf(ofB[j], a.graph.vertices()[i].place)) / 2;
      if (apart <= fitted::kMaxGrown) near[i].push_back({j, apart});
    }
  return near;
}

/** A pair that waits to be taken. */
struct Candidate {
  double cost = 0;
  std::uint32_t a = 0, b = 0;
  double distance = 0;
  bool mayStand = true;  ///< without a way that is matched, too

  /** The least cost is the top of a queue. */
  friend bool operator<(const Candidate& l, const Candidate& r) {
    return std::tie(l.cost, l.a, l.b) > std::tie(r.cost, r.a, r.b);
  }
};

class Matcher {
 public:
  Matcher(const FollowedGraph& a, const FollowedGraph& b)
      : a_(a.graph),
        b_(b.graph),
        near_(nearVertices(a, b)),
        ofA_(a_.vertices().size()),
        ofB_(b_.vertices().size()) {}

  std::vector<VertexMatch> match() {
    offerAll();
    while (!queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if (ofA_[next.a] || ofB_[next.b]) continue;
      ofA_[next.a] = next, ofB_[next.b] = next;
      offerAround(next);
    }
    std::vector<VertexMatch> matches;
    for (const auto& found : ofA_)
      if (found && (found->mayStand || found->distance <= fitted::kMaxSeed / 2))
        matches.push_back({VertexId(found->a), VertexId(found->b), found->distance});
    return matches;
  }

 private:
  /** None where one of them is a room and the other is not. */
  std::optional<double> unlikeness(std::uint32_t i, std::uint32_t j) const {
    const Vertex &v = a_.vertices()[i], &w = b_.vertices()[j];
    if ((v.kind == VertexKind::room) != (w.kind == VertexKind::room)) return std::nullopt;
    const int exits = std::abs(int(a_.degree(VertexId(i))) - int(b_.degree(VertexId(j))));
    return (v.kind == w.kind ? 0 : fitted::kOtherKind) + fitted::kOtherKind / 2 * exits +
           fitted::kPerMetre * std::min(1.0, std::abs(v.clearance - w.clearance));
  }

  bool lookAlike(std::uint32_t i, std::uint32_t j) const {
    const Vertex &v = a_.vertices()[i], &w = b_.vertices()[j];
    return v.kind == w.kind && a_.degree(VertexId(i)) == b_.degree(VertexId(j)) &&
           std::abs(v.clearance - w.clearance) <= fitted::kAlikeWidth;
  }

  void offerAll() {
    for (std::uint32_t i = 0; i < near_.size(); ++i)
      for (const auto& [j, apart] : near_[i]) {
        const auto unlike = unlikeness(i, j);
        if (!unlike || apart > fitted::kMaxSeed) continue;
        const bool isSeed = lookAlike(i, j);
        queue_.push({apart + *unlike + (isSeed ? 0 : fitted::kMaxSeed), i, j, apart, isSeed});
      }
  }

  /** Offers the neighbours of a pair, over edges of about the same length. */
  void offerAround(const Candidate& pair) {
    for (const HalfEdgeId h : a_.outgoing(VertexId(pair.a))) {
      const auto i = std::uint32_t(a_.target(h).index());
      if (ofA_[i]) continue;
      for (const HalfEdgeId g : b_.outgoing(VertexId(pair.b))) {
        const auto j = std::uint32_t(b_.target(g).index());
        if (ofB_[j]) continue;
        const double ofA = a_.edge(h).path.length, ofB = b_.edge(g).path.length;
        if (!isSameLength(ofA, ofB)) continue;
        const auto found = std::find_if(near_[i].begin(), near_[i].end(),
                                        [&](const auto& one) { return one.first == j; });
        const auto unlike = unlikeness(i, j);
        if (found == near_[i].end() || !unlike) continue;
        // The way from a matched vertex makes up for another kind.
        const double cost =
            found->second + *unlike + fitted::kPerMetre * std::abs(ofA - ofB) - fitted::kOtherKind;
        queue_.push({cost, i, j, found->second, true});
      }
    }
  }

  const TopologyGraph &a_, &b_;
  const Near near_;
  std::vector<std::optional<Candidate>> ofA_, ofB_;
  std::priority_queue<Candidate> queue_;
};

double overallLength(const TopologyGraph& graph) {
  double sum = 0;
  for (const Edge& edge : graph.edges()) sum += edge.path.length;
  return sum;
}

/** Of the edges that are part of a path, each once. */
double sharedLength(const TopologyGraph& graph, const std::vector<PathMatch>& paths,
                    std::vector<HalfEdgeId> PathMatch::*side) {
  std::vector<bool> isShared(graph.edges().size());
  double sum = 0;
  for (const PathMatch& path : paths)
    for (const HalfEdgeId h : path.*side) {
      const std::size_t edge = TopologyGraph::edgeOf(h).index();
      if (!isShared[edge]) sum += graph.edges()[edge].path.length;
      isShared[edge] = true;
    }
  return sum;
}

}  // namespace

GraphMatch matchGraphs(const FollowedGraph& a, const FollowedGraph& b) {
  GraphMatch result;
  result.overallInA = overallLength(a.graph), result.overallInB = overallLength(b.graph);
  if (a.followed.patches.empty() || b.followed.patches.empty()) return result;
  result.vertices = Matcher(a, b).match();
  result.paths = sharedPaths(a.graph, b.graph, result.vertices);
  result.sharedInA = sharedLength(a.graph, result.paths, &PathMatch::a);
  result.sharedInB = sharedLength(b.graph, result.paths, &PathMatch::b);
  return result;
}

}  // namespace roomgraph
