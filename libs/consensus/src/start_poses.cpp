#include "start_poses.h"

#include <deque>
#include <optional>
#include <utility>

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

}  // namespace

NodePoses startPoses(const PoseGraph& graph, RunId pivot) { return Placing(graph).placed(pivot); }

}  // namespace roomgraph
