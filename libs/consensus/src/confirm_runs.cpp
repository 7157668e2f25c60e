#include "confirm_runs.h"

#include <algorithm>
#include <cmath>

#include "edge_cost.h"
#include "fitted_consensus.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/consensus/belief.h"

namespace roomgraph {
namespace {

/** What the others know of the places of one run's scans. */
class OtherRuns {
 public:
  OtherRuns(const Consensus& consensus, const Site& site, const MapPairs& pairs, RunId run)
      : consensus_(consensus), site_(site), run_(consensus.siteRuns[run]) {
    for (const std::size_t j : pairs.othersOf(run_))
      if (consensus.isCounted(j) && !site.mapOf(j).isBare()) others_.push_back(j);
  }

  /** Whether one of them knows the place of a scan, and none that does has what the scan shows. */
  bool contradict(std::size_t k) const {
    const ScanWalls& scan = site_.runs[run_]->scans[k];
    if (scan.walls.size() < LocalScan::kTelling) return false;
    bool isKnown = false;
    for (const std::size_t j : others_) {
      const WallShare share = wallShare(
          scan.walls.size(), [&](std::size_t w) -> const WallPoint& { return scan.walls[w]; },
          site_.mapOf(j), poseIn(j, k) * scan.pose.inverse(), kSameWhereBent);
      if (share.known <= kMajority * share.all) continue;
      if (share.ofKnown() >= fitted::kLeastQuality) return false;
      isKnown = true;
    }
    return isKnown;
  }

 private:
  /** Where a scan would lie in the map of another run, as that is bent there. */
  Transform2D poseIn(std::size_t other, std::size_t scan) const {
    const Transform2D& there = consensus_.poses[consensus_.nodesOf(run_)[scan]];
    const NodeId nearest = nearestNode(consensus_.nodesOf(other), consensus_.poses, there.shift());
    return consensus_.graph.nodes[nearest].pose * consensus_.poses[nearest].inverse() * there;
  }

  const Consensus& consensus_;
  const Site& site_;
  std::size_t run_;
  std::vector<std::size_t> others_;
};

/** A stretch that nobody bears out. */
struct Unconfirmed {
  ScanStretch scans;
  bool isContradicted = false;
};

/** How much a stretch has drawn, and how far that reaches. */
class Extent {
 public:
  Extent(const Consensus& consensus, RunId run, const ScanStretch& scans)
      : graph_(consensus.graph), run_(run), scans_(scans), slack_(consensus.trust.slack[run]) {
    const Point joint = node(scans.first > 0 ? scans.first - 1 : scans.end).pose.shift();
    for (std::size_t k = scans.first; k < scans.end; ++k) {
      const PoseNode& drawn = node(k);
      const PointSums& p = drawn.points;
      const Point place = drawn.pose.shift() - joint, sum = turned({p.x, p.y}, drawn.pose.phi);
      points_ += p.count;
      squares_ += p.xx + p.yy + 2 * dot(place, sum) + p.count * squaredNorm(place);
    }
  }

  double points() const { return points_; }
  /** Root mean square distance of what it has drawn from where it begins [m]. */
  double reach() const { return points_ > 0 ? std::sqrt(squares_ / points_) : 0; }
  /** How far its own links let it drift [m]. */
  double drift() const {
    double place = 0, turn = 0;
    for (const PoseEdgeId id : graph_.runs[run_].links) {
      const PoseEdge& link = graph_.edges[id];
      const std::size_t k = graph_.runs[run_].nodes.placeOf(link.to);
      if (k < scans_.first || k >= scans_.end) continue;
      const PoseNoise noise = linkTerm(link, slack_).noise;
      place += noise.place * noise.place, turn += noise.turn * noise.turn;
    }
    return std::sqrt(place + turn * reach() * reach());
  }

 private:
  const PoseNode& node(std::size_t k) const {
    const IdRange<NodeId>& nodes = graph_.runs[run_].nodes;
    return graph_.nodes[nodes[std::min(k, nodes.size() - 1)]];
  }

  const PoseGraph& graph_;
  RunId run_;
  ScanStretch scans_;
  double slack_, points_ = 0, squares_ = 0;
};

/** Whether others contradict so many scans on end that it is neither people nor glass. */
bool areContradicted(const ScanStretch& gap, const OtherRuns& others) {
  long onEnd = 0;
  for (std::size_t k = gap.first; k < gap.end; ++k) {
    onEnd = others.contradict(k) ? onEnd + 1 : 0;
    if (onEnd >= fitted::kLeastLostOnEnd) return true;
  }
  return false;
}

std::vector<Unconfirmed> unconfirmedIn(const Consensus& consensus, const Site& site,
                                       const MapPairs& pairs, RunId run,
                                       const std::vector<bool>& isFound) {
  const OtherRuns others(consensus, site, pairs, run);
  const std::vector<ScanWalls>& scans = site.runs[consensus.siteRuns[run]]->scans;
  std::vector<Unconfirmed> all;
  for (const ScanStretch& gap : gapsOf(isFound)) {
    const bool isContradicted =
        gap.size() >= std::size_t(fitted::kLeastLostOnEnd) && areContradicted(gap, others);
    if (isContradicted || isLong(gap, scans)) all.push_back({gap, isContradicted});
  }
  return all;
}

void addUnconfirmed(Consensus& consensus, RunId run, const std::vector<Unconfirmed>& all) {
  MapError& error = consensus.errors[run];
  const IdRange<NodeId>& nodes = consensus.graph.runs[run].nodes;
  error.isConfirmed.assign(nodes.size(), true);
  double drawn = 0, unconfirmed = 0, contradicted = 0, squares = 0;
  for (const NodeId node : nodes) drawn += consensus.graph.nodes[node].points.count;
  if (drawn <= 0) return;
  for (const auto& [scans, isContradicted] : all) {
    const Extent extent(consensus, run, scans);
    const double off = isContradicted ? 2 * extent.reach() : kEightyPercent * extent.drift();
    unconfirmed += extent.points(), squares += extent.points() * off * off;
    if (isContradicted) contradicted += extent.points();
    for (std::size_t k = scans.first; k < scans.end; ++k) error.isConfirmed[k] = false;
  }
  error.confirmed = 1 - unconfirmed / drawn, error.contradicted = contradicted / drawn;
  error.high = std::hypot(error.high, std::sqrt(squares / drawn));
}

}  // namespace

void confirmRuns(Consensus& consensus, const Site& site, const MapPairs& pairs) {
  const PoseGraph& graph = consensus.graph;
  const auto isConfirmed = confirmedNodes(graph, consensus.poses, consensus.trust.belief);
  for (const RunId run : graph.runs.ids()) {
    if (run == graph.reference || !graph.runs[run].hasScans) continue;
    std::vector<bool> isFound;
    for (const NodeId node : graph.runs[run].nodes) isFound.push_back(isConfirmed[node]);
    addUnconfirmed(consensus, run, unconfirmedIn(consensus, site, pairs, run, isFound));
  }
}

ById<NodeId, bool> confirmedNodes(const PoseGraph& graph, const NodePoses& poses,
                                  const ById<MatchGroupId, double>& belief) {
  ById<NodeId, bool> isConfirmed(graph.nodes.size());
  for (const MatchGroupId id : graph.groups.ids()) {
    const MatchGroup& group = graph.groups[id];
    if (group.from == group.to || belief[id] < beliefOf(kMajority)) continue;
    for (const PoseEdgeId match : group.edges) {
      const PoseEdge& edge = graph.edges[match];
      if (isInlier(edge, gapOf(edge, poses), kInlier))
        isConfirmed[edge.to] = isConfirmed[edge.from] = true;
    }
  }
  return isConfirmed;
}

std::vector<ScanStretch> gapsOf(const std::vector<bool>& isFound) {
  std::vector<ScanStretch> gaps;
  for (std::size_t k = 0; k < isFound.size(); ++k) {
    if (isFound[k]) continue;
    ScanStretch gap{k, k};
    while (gap.end < isFound.size() && !isFound[gap.end]) ++gap.end;
    gaps.push_back(gap);
    k = gap.end;
  }
  return gaps;
}

bool isLong(const ScanStretch& stretch, const std::vector<ScanWalls>& scans) {
  const std::vector<double> ways = drivenWays(scans);
  return stretch.size() >= fitted::kLongScans ||
         ways[stretch.end - 1] - ways[stretch.first] >= fitted::kLongWay;
}

}  // namespace roomgraph
