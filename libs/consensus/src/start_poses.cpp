#include "start_poses.h"

#include <deque>
#include <optional>
#include <utility>

#include "edge_cost.h"
#include "roomgraph/consensus/belief.h"

namespace roomgraph {
namespace {

using Found = ById<NodeId, std::optional<Transform2D>>;

/** Runs that are brought into one frame, one after the other. */
class Placing {
 public:
  explicit Placing(const PoseGraph& graph)
      : graph_(graph), poses_(graph.ownPoses()), isPlaced_(graph.runs.size()) {}

  NodePoses placed(RunId pivot) {
    isPlaced_[pivot] = true;
    while (const RunId next = mostFound()) {
      spread(graph_.runs[next], foundNodes(next, pivot));
      isPlaced_[next] = true;
    }
    return std::move(poses_);
  }

 private:
  /** The run of which most was found in those that are placed, of equal ones the first. */
  RunId mostFound() const {
    ById<RunId, std::size_t> counts(graph_.runs.size());
    for (const MatchGroup& group : graph_.groups)
      for (const auto& [run, other] : {std::pair(group.to, group.from), {group.from, group.to}})
        if (!isPlaced_[run] && isPlaced_[other]) counts[run] += group.edges.size();
    RunId most;
    for (const RunId run : counts.ids())
      if (counts[run] > 0 && (!most || counts[run] > counts[most])) most = run;
    return most;
  }

  /** Where the nodes of a run were found: in the pivot, else in another run that is placed. */
  Found foundNodes(RunId run, RunId pivot) const {
    Found found(graph_.nodes.size());
    for (const bool isPivot : {true, false})
      for (const MatchGroup& group : graph_.groups) {
        if (group.from != run && group.to != run) continue;
        for (const PoseEdgeId edge : group.edges)
          for (const HalfEdge& half : halvesOf(graph_.edges[edge])) {
            const RunId other = graph_.runOf(half.other);
            if (graph_.runOf(half.node) == run && isPlaced_[other] && (other == pivot) == isPivot &&
                !found[half.node])
              found[half.node] = poses_[half.other] * half.measured;
          }
      }
    return found;
  }

  /** Lets what was not found keep its pose to the nearest node that was, along the links. */
  void spread(const GraphRun& run, const Found& found) {
    ById<NodeId, std::vector<NodeId>> beside(graph_.nodes.size());
    for (const PoseEdgeId id : run.links) {
      const PoseEdge& link = graph_.edges[id];
      beside[link.from].push_back(link.to), beside[link.to].push_back(link.from);
    }
    ById<NodeId, std::optional<Transform2D>> carry(graph_.nodes.size());  // site <- run
    std::deque<NodeId> front;
    for (const NodeId node : run.nodes)
      if (found[node]) {
        carry[node] = *found[node] * graph_.nodes[node].pose.inverse();
        front.push_back(node);
      }
    const Transform2D any = front.empty() ? Transform2D{} : *carry[front.front()];
    for (; !front.empty(); front.pop_front())
      for (const NodeId next : beside[front.front()])
        if (!carry[next]) {
          carry[next] = carry[front.front()];
          front.push_back(next);
        }
    for (const NodeId node : run.nodes)
      poses_[node] = carry[node].value_or(any) * graph_.nodes[node].pose;
  }

  const PoseGraph& graph_;
  NodePoses poses_;
  ById<RunId, bool> isPlaced_;
};

class Voting {
 public:
  explicit Voting(const PoseGraph& graph)
      : graph_(graph), wholes_(graph.runs.size()), isPlaced_(graph.runs.size()) {
    for (const PoseNode& node : graph.nodes) own_.add(TurnedPose(node.pose));
  }

  /** All runs placed, beginning with this one: always the run next for which most speaks. */
  void placeFrom(RunId first) {
    isPlaced_[first] = true;
    while (placeNext()) {
    }
  }

  NodePoses poses() const {
    NodePoses poses;
    for (const PoseNode& node : graph_.nodes) poses.add(wholes_[node.run] * node.pose);
    return poses;
  }

 private:
  struct Place {
    Transform2D whole;
    double support = 0;
  };

  bool placeNext() {
    RunId next;
    Place best;
    for (const RunId run : graph_.runs.ids()) {
      if (isPlaced_[run]) continue;
      if (const Place place = bestPlace(run); place.support > best.support)
        best = place, next = run;
    }
    if (!next) return false;
    wholes_[next] = best.whole;
    return isPlaced_[next] = true;
  }

  /** Whether a group tells where a run lies to one that is placed. */
  bool tellsOf(const MatchGroup& group, RunId run) const {
    return (group.to == run && group.from != run && isPlaced_[group.from]) ||
           (group.from == run && group.to != run && isPlaced_[group.to]);
  }

  /** Of the places where a group would have the run, that with which most matches agree. */
  Place bestPlace(RunId run) const {
    Place best;
    for (const MatchGroup& group : graph_.groups) {
      if (!tellsOf(group, run)) continue;
      for (const HalfEdge& half : halvesOf(graph_.edges[group.edges[group.edges.size() / 2]])) {
        if (graph_.runOf(half.node) != run) continue;
        const Transform2D whole = wholes_[graph_.runOf(half.other)] *
                                  graph_.nodes[half.other].pose * half.measured *
                                  graph_.nodes[half.node].pose.inverse();
        if (const double support = supportOf(run, whole); support > best.support)
          best = {whole, support};
      }
    }
    return best;
  }

  /** The matches with placed runs that agree with where this run lies. */
  double supportOf(RunId run, const Transform2D& whole) const {
    ById<RunId, TurnedPose> wholes;
    for (const RunId id : graph_.runs.ids())
      wholes.add(TurnedPose(id == run ? whole : wholes_[id]));
    const auto poseOf = [&](NodeId id) { return wholes[graph_.runOf(id)] * own_[id]; };
    double support = 0;
    for (const MatchGroup& group : graph_.groups) {
      if (!tellsOf(group, run)) continue;
      for (const PoseEdgeId id : group.edges) {
        const PoseEdge& edge = graph_.edges[id];
        if (isInlier(edge, poseOf(edge.from).gapOf(edge, poseOf(edge.to)), kRoughly))
          support += edge.share;
      }
    }
    return support;
  }

  const PoseGraph& graph_;
  ById<NodeId, TurnedPose> own_;     // run <- node
  ById<RunId, Transform2D> wholes_;  // site <- run
  ById<RunId, bool> isPlaced_;
};

}  // namespace

NodePoses startPoses(const PoseGraph& graph, RunId pivot) { return Placing(graph).placed(pivot); }

NodePoses wholePoses(const PoseGraph& graph) {
  Voting voting(graph);
  voting.placeFrom(graph.reference ? graph.reference : RunId(0));
  return voting.poses();
}

}  // namespace roomgraph
