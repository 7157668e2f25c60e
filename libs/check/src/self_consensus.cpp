#include "self_consensus.h"

#include <algorithm>
#include <optional>

#include "Passes.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/majority.h"
#include "roomgraph/consensus/belief.h"
#include "roomgraph/consensus/solve_pose_graph.h"

namespace roomgraph {
namespace {

constexpr double kLeastScore = 8, kLeastHold = 0.08;

class Finder {
 public:
  Finder(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& poses)
      : scans_(scans), poses_(poses), passes_(scans, poses) {}

  std::vector<Revisit> find() {
    std::vector<Revisit> groups;
    for (const Pass& pass : passes_.all()) {
      std::optional<std::size_t> last;
      Transform2D lastShift;
      for (std::size_t k = 0; k < poses_.size(); ++k) {
        if (!isWanted(k, pass)) continue;
        const auto found = findIn(k, pass);
        if (!found) continue;
        const Transform2D moved = *found * poses_[k].inverse();
        const bool goesOn = last && passes_.pathBetween(*last, k) < Passes::kLength &&
                            areNear(moved, lastShift, poses_[k].shift(), kSteadyTrack);
        if (!goesOn) groups.emplace_back();
        last = k, lastShift = moved;
        groups.back().push_back(edgeTo(k, *found, pass));
      }
    }
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                                [](const Revisit& group) { return group.size() < 2; }),
                 groups.end());
    return groups;
  }

 private:
  bool isWanted(std::size_t k, const Pass& pass) const {
    const auto s = std::size_t(&pass - passes_.all().data());
    const auto& beside = passes_.besideScan(k);
    return std::find(beside.begin(), beside.end(), s) != beside.end();
  }

  static bool isGood(const ScanFit& fit) {
    return fit.score >= kLeastScore && fit.quality >= kMajority && fit.hold >= kLeastHold;
  }

  std::optional<Transform2D> findIn(std::size_t k, const Pass& pass) const {
    if (pass.map.walls.empty()) return std::nullopt;
    const ScanFit here = fitNear(scans_[k], pass.map, poses_[k]);
    if (here.quality >= kSureQuality && isGood(here)) return here.pose;
    const auto found = findScan(scans_[k], pass.map, poses_[k], passes_.windowOf(k, pass), 2);
    if (isGood(here) && (found.empty() || found.front().score < here.score / kRivalScore))
      return here.pose;
    if (found.empty() || !isGood(found.front())) return std::nullopt;
    if (found.size() > 1 && found[1].score > kRivalScore * found[0].score) return std::nullopt;
    return found.front().pose;
  }

  PoseEdge edgeTo(std::size_t k, const Transform2D& found, const Pass& pass) const {
    const std::size_t in = passes_.nearestScan(pass, found.shift());
    return matchEdge(NodeId(in), NodeId(k), poses_[in].inverse() * found, 1);
  }

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& poses_;
  Passes passes_;
};

/** The run at other poses than it has. */
PoseGraph graphAt(const Run& run, const std::vector<Transform2D>& poses,
                  const std::vector<Revisit>& revisits) {
  PoseGraph graph;
  const RunId id = graph.addRun(true);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const NodeId node = graph.addNode(poses[k], run.scans[k].ends, run.scans[k].axes);
    if (k > 0) graph.addLink(NodeId(k - 1), node);
  }
  for (const Revisit& revisit : revisits) graph.addGroup({id, id, {}}, revisit);
  return graph;
}

std::vector<Transform2D> solvedFrom(const PoseGraph& graph, const std::vector<Transform2D>& start,
                                    StartIs startIs) {
  GraphTrust trust{ById<RunId, double>(1, 1.0),
                   ById<MatchGroupId, double>(graph.groups.size(), 1.0)};
  NodePoses poses = solvePoseGraph(graph, trust, NodePoses(start), startIs).poses;
  trust = {runSlack(graph, poses), beliefIn(graph, poses, kInlier)};
  poses = solvePoseGraph(graph, trust, poses, StartIs::good).poses;
  return {poses.begin(), poses.end()};
}

/** The error of the run as it was drawn, and what of it was seen twice. */
MapError errorOf(const Run& run, const std::vector<Revisit>& revisits,
                 const std::vector<Transform2D>& poses) {
  MapError error = mapError(graphAt(run, drawnPoses(run.scans), {}), RunId(0), NodePoses(poses), 1);
  for (const Revisit& revisit : revisits)
    for (const PoseEdge& edge : revisit)
      error.isSeen[edge.from.index()] = error.isSeen[edge.to.index()] = true;
  return error;
}

}  // namespace

std::vector<Revisit> findRevisits(const std::vector<LocalScan>& scans,
                                  const std::vector<Transform2D>& poses) {
  return Finder(scans, poses).find();
}

bool isBorneOut(const PoseEdge& revisit, const std::vector<Transform2D>& poses) {
  const Transform2D found = poses[revisit.from.index()].inverse() * poses[revisit.to.index()];
  return areNear(revisit.measured, found, {}, kNextPatch);
}

SelfConsensus selfConsensus(const Run& run, const std::vector<LocalScan>& scans,
                            const MendedSteps& mended) {
  SelfConsensus result;
  result.poses = mended.poses;
  std::vector<Revisit> revisits;
  for (const StartIs startIs : {StartIs::rough, StartIs::good}) {
    revisits = findRevisits(scans, result.poses);
    result.poses = solvedFrom(graphAt(run, mended.poses, revisits), result.poses, startIs);
  }
  result.error = errorOf(run, revisits, result.poses);
  for (const Revisit& revisit : revisits)
    result.revisits.insert(result.revisits.end(), revisit.begin(), revisit.end());
  const Transform2D back = result.error.pose.inverse();
  for (Transform2D& pose : result.poses) pose = back * pose;
  return result;
}

bool isConfirmed(const SelfConsensus& consensus, const std::vector<std::size_t>& breaks) {
  std::vector<std::size_t> across(breaks.size(), 0);
  std::size_t fits = 0;
  for (const PoseEdge& edge : consensus.revisits) {
    const std::size_t from = edge.from.index(), to = edge.to.index();
    if (!isBorneOut(edge, consensus.poses)) continue;
    ++fits;
    for (std::size_t i = 0; i < breaks.size(); ++i)
      if (std::min(from, to) < breaks[i] && breaks[i] <= std::max(from, to)) ++across[i];
  }
  return fits > kFitsPerMiss * (consensus.revisits.size() - fits) &&
         std::all_of(across.begin(), across.end(),
                     [](std::size_t count) { return count >= kLeastAcross; });
}

}  // namespace roomgraph
