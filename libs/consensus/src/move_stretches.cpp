#include "move_stretches.h"

#include <algorithm>
#include <optional>

#include "edge_cost.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/consensus/belief.h"

namespace roomgraph {
namespace {

constexpr double kLenient = 4;  // times the noise of matches: what is left over the solver mends
constexpr int kAskEvery = 8;    // nodes, whether a motion can still be the best

/** Nodes first to last of a run. */
struct Stretch {
  RunId run;
  NodeId first, last;

  bool has(NodeId node) const { return !(node < first) && !(last < node); }
  IdRange<NodeId> nodes() const { return {first.index(), last.index() + 1}; }
  NodeId middle() const { return nodes()[(nodes().size() - 1) / 2]; }
  bool operator==(const Stretch& o) const {
    return run == o.run && first == o.first && last == o.last;
  }
};

/** An edge as one of its nodes sees it. */
struct Tie {
  PoseEdgeId edge;
  HalfEdge half;
};

/** What the matches of a group say. */
struct GroupSum {
  double cost = 0, inliers = 0;  // as if all of it were believed
};

class Mover {
 public:
  Mover(const PoseGraph& graph, const ById<RunId, double>& slack, NodePoses& poses)
      : graph_(graph),
        slack_(slack),
        poses_(poses),
        turned_(graph.nodes.size()),
        ties_(graph.nodes.size()),
        states_(graph.edges.size()),
        sums_(graph.groups.size()),
        hopes_(graph.groups.size()),
        changes_(graph.groups.size()),
        isTouched_(graph.groups.size()) {
    for (const NodeId node : poses.ids()) turned_[node] = TurnedPose(poses[node]);
    for (const PoseEdgeId id : graph.edges.ids()) {
      const PoseEdge& edge = graph.edges[id];
      for (const HalfEdge& half : halvesOf(edge)) ties_[half.node].push_back({id, half});
      terms_.add(termOf(edge));
      states_[id] = stateAt(id, turned_[edge.from], turned_[edge.to]);
      if (edge.group) add(sums_[edge.group], states_[id], 1);
    }
  }

  void move() {
    for (int round = 0; round < 8; ++round) {
      bool hasMoved = false;
      for (const Stretch& stretch : stretches()) hasMoved |= place(stretch);
      if (!hasMoved) return;
    }
  }

 private:
  struct EdgeState {
    double cost = 0;
    bool isInlier = false;
  };

  EdgeState stateAt(PoseEdgeId id, const TurnedPose& from, const TurnedPose& to) const {
    const PoseEdge& edge = graph_.edges[id];
    const PoseGap gap = from.gapOf(edge, to);
    const double leap = costOfLeap(edge, distance(from.shift, to.shift));
    const double cost = terms_[id].cost(gap) + leap;
    return {cost, edge.group && isInlier(edge, gap, kInlier)};
  }

  /** As if every group were believed. */
  EdgeTerm termOf(const PoseEdge& edge) const {
    if (!edge.group) return linkTerm(edge, slack_[graph_.runOf(edge.from)]);
    EdgeTerm term = matchTerm(edge, 1);
    term.noise = term.noise.times(kLenient);
    return term;
  }

  static void add(GroupSum& sum, const EdgeState& state, double sign) {
    sum.cost += sign * state.cost, sum.inliers += sign * state.isInlier;
  }

  /** What a group costs, believed as far as its matches are inliers. */
  double costOf(MatchGroupId id, const GroupSum& sum) const {
    const MatchGroup& group = graph_.groups[id];
    const double belief = beliefOf(sum.inliers / double(group.edges.size()));
    return belief * sum.cost + (1 - belief) * costOfGivingUp(group);
  }

  /** The stretches that may belong elsewhere, shortest first: between links that gave way, all
   *  before and all behind one, whole runs, and what a group that is doubted was found of. */
  std::vector<Stretch> stretches() const {
    std::vector<Stretch> all;
    for (const RunId run : graph_.runs.ids()) addStretches(run, all);
    for (const MatchGroupId id : graph_.groups.ids()) {
      const MatchGroup& group = graph_.groups[id];
      const double share = sums_[id].inliers / double(group.edges.size());
      if (!isMovable(group.to) || beliefOf(share) >= kMajority) continue;
      addCuts({group.to, graph_.edges[group.edges.front()].to, graph_.edges[group.edges.back()].to},
              all);
    }
    sortBy(all, [](const Stretch& stretch) { return stretch.nodes().size(); });
    return all;
  }

  bool isMovable(RunId run) const {
    const GraphRun& it = graph_.runs[run];
    return it.hasScans && !it.nodes.isEmpty() && run != graph_.reference;
  }

  void addStretches(RunId id, std::vector<Stretch>& all) const {
    if (!isMovable(id)) return;
    const GraphRun& run = graph_.runs[id];
    NodeId first = run.nodes.front();
    addOnce({id, first, run.nodes.back()}, all);
    for (const PoseEdgeId link : run.links) {
      if (states_[link].cost <= kGaveWay) continue;
      addCuts({id, first, graph_.edges[link].from}, all);
      first = graph_.edges[link].to;
    }
    if (first != run.nodes.front()) addCuts({id, first, run.nodes.back()}, all);
  }

  /** A stretch, and all from its ends on either way. */
  void addCuts(const Stretch& stretch, std::vector<Stretch>& all) const {
    const IdRange<NodeId>& nodes = graph_.runs[stretch.run].nodes;
    addOnce(stretch, all);
    addOnce({stretch.run, nodes.front(), stretch.last}, all);
    addOnce({stretch.run, stretch.first, nodes.back()}, all);
  }

  static void addOnce(const Stretch& stretch, std::vector<Stretch>& all) {
    if (!contains(all, stretch)) all.push_back(stretch);
  }

  /** The edges that hold a stretch: those that lead out of it. */
  template <class Do>
  void eachTieOf(const Stretch& stretch, const Do& todo) const {
    for (const NodeId node : stretch.nodes())
      for (const Tie& tie : ties_[node])
        if (!stretch.has(tie.half.other)) todo(tie);
  }

  /** The edge of a tie once its node lies there (site <- node). */
  EdgeState stateBy(const Tie& tie, const TurnedPose& moved) const {
    const PoseEdge& edge = graph_.edges[tie.edge];
    return tie.half.node == edge.to ? stateAt(tie.edge, turned_[edge.from], moved)
                                    : stateAt(tie.edge, moved, turned_[edge.to]);
  }

  /** What the best of all motions would change: nothing that holds the stretch costs anything. */
  void hopeFor(const Stretch& stretch) {
    for (const MatchGroupId group : touched_) hopes_[group] = {}, isTouched_[group] = false;
    touched_.clear();
    hope_ = 0;
    eachTieOf(stretch, [&](const Tie& tie) {
      const EdgeState& before = states_[tie.edge];
      const MatchGroupId group = graph_.edges[tie.edge].group;
      if (!group) {
        hope_ -= before.cost;
        return;
      }
      if (!isTouched_[group]) touched_.push_back(group), hope_ -= costOf(group, sums_[group]);
      isTouched_[group] = true;
      hopes_[group].cost -= before.cost, hopes_[group].inliers += !before.isInlier;
    });
  }

  /** By how much the cost changes once the stretch, which was hoped for, has been moved (site <-
   *  site); `most` as soon as it is sure not to be less. */
  double changeBy(const Stretch& stretch, const TurnedPose& motion, double most) {
    for (const MatchGroupId group : touched_) changes_[group] = hopes_[group];
    double links = hope_;
    const auto change = [&](bool isAll) {
      double sum = links;
      for (const MatchGroupId group : touched_) {
        const double cost = costOf(group, {sums_[group].cost + changes_[group].cost,
                                           sums_[group].inliers + changes_[group].inliers});
        // It may still be given up.
        sum += isAll ? cost : std::min(cost, costOfGivingUp(graph_.groups[group]));
      }
      return sum;
    };
    int asked = 0;
    for (const NodeId node : stretch.nodes()) {
      if (++asked % kAskEvery == 0 && change(false) >= most) return most;
      const TurnedPose moved = motion * turned_[node];
      for (const Tie& tie : ties_[node]) {
        if (stretch.has(tie.half.other)) continue;
        const EdgeState after = stateBy(tie, moved);
        const MatchGroupId group = graph_.edges[tie.edge].group;
        (group ? changes_[group].cost : links) += after.cost;
        if (group) changes_[group].inliers -= !after.isInlier;
      }
    }
    return change(true);
  }

  /** Motions that bring the stretch to where one of its links or matches would have it. */
  std::vector<Transform2D> motionsOf(const Stretch& stretch) const {
    std::vector<Transform2D> motions;
    std::vector<Point> places;  // where each brings the middle
    const Point middle = poses_[stretch.middle()].shift();
    const auto offer = [&](const HalfEdge& half) {
      if (motions.size() == 24) return;  // where much is found, the cost has a bound
      const Transform2D wanted = poses_[half.other] * half.measured;
      const Transform2D motion = wanted * poses_[half.node].inverse();
      const Point place = motion(middle);
      const auto isAt = [&](double turn, Point point, const PoseTolerance& within) {
        return std::abs(wrappedAngle(turn - motion.phi)) < within.turn &&
               distance(point, place) < within.place;
      };
      if (isAt(0, middle, kInlier)) return;
      for (std::size_t i = 0; i < motions.size(); ++i)
        if (isAt(motions[i].phi, places[i], kSameStart)) return;
      motions.push_back(motion), places.push_back(place);
    };
    for (const bool isLink : {true, false})
      eachTieOf(stretch, [&](const Tie& tie) {
        if (!graph_.edges[tie.edge].group == isLink) offer(tie.half);
      });
    return motions;
  }

  bool place(const Stretch& stretch) {
    double best = -1;  // so that rounding decides nothing
    std::optional<Transform2D> chosen;
    hopeFor(stretch);
    for (const Transform2D& motion : motionsOf(stretch))
      if (const double change = changeBy(stretch, TurnedPose(motion), best); change < best)
        best = change, chosen = motion;
    if (!chosen) return false;
    for (const NodeId node : stretch.nodes()) {
      poses_[node] = *chosen * poses_[node];
      turned_[node] = TurnedPose(poses_[node]);
    }
    eachTieOf(stretch, [&](const Tie& tie) {
      const PoseEdge& edge = graph_.edges[tie.edge];
      const EdgeState before = states_[tie.edge];
      states_[tie.edge] = stateAt(tie.edge, turned_[edge.from], turned_[edge.to]);
      if (!edge.group) return;
      add(sums_[edge.group], before, -1);
      add(sums_[edge.group], states_[tie.edge], 1);
    });
    return true;
  }

  const PoseGraph& graph_;
  const ById<RunId, double>& slack_;
  NodePoses& poses_;
  ById<NodeId, TurnedPose> turned_;  // the same
  ById<NodeId, std::vector<Tie>> ties_;
  ById<PoseEdgeId, EdgeTerm> terms_;
  ById<PoseEdgeId, EdgeState> states_;                   // where the nodes lie now
  ById<MatchGroupId, GroupSum> sums_, hopes_, changes_;  // now, and by the best motion and by one
  ById<MatchGroupId, bool> isTouched_;                   // whether hopes_ is something
  std::vector<MatchGroupId> touched_;                    // those groups
  double hope_ = 0;  // by the best motion, without what groups cost then
};

}  // namespace

void moveStretches(const PoseGraph& graph, const ById<RunId, double>& slack, NodePoses& poses) {
  Mover(graph, slack, poses).move();
}

}  // namespace roomgraph
