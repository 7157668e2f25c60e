#include "roomgraph/consensus/belief.h"

#include <algorithm>
#include <cmath>

#include "fitted_consensus.h"
#include "roomgraph/relate/shared_drives.h"

namespace roomgraph {
namespace {

ById<RunId, bool> haveSharedDrives(const PoseGraph& graph) {
  ById<RunId, bool> isShared(graph.runs.size());
  for (const MatchGroup& group : graph.groups) {
    std::size_t same = 0;
    for (const PoseEdgeId edge : group.edges) same += graph.edges[edge].isSameScan;
    for (const RunId run : {group.to, group.from})
      if (sharesDrive(same, graph.runs[run].nodes.size())) isShared[run] = true;
  }
  return isShared;
}

/** The mean squared residual of a run's links, in units of what they allow with a slack of 1; of
 *  the tenth that gives way most nothing is counted. */
double meanStrain(const PoseGraph& graph, const GraphRun& run, const NodePoses& poses) {
  std::vector<double> strains;
  for (const PoseEdgeId id : run.links) {
    const PoseEdge& link = graph.edges[id];
    const PoseGap gap = gapOf(link, poses);
    const double place = gap.place / link.noise.place, turn = gap.turn / link.noise.turn;
    strains.push_back((place * place + turn * turn) / 3);
  }
  std::sort(strains.begin(), strains.end());
  strains.resize(std::size_t(fitted::kCountedLinks * double(strains.size())));
  double sum = 0;
  for (const double strain : strains) sum += strain;
  return strains.empty() ? 0 : sum / double(strains.size());
}

}  // namespace

double beliefOf(double share) { return std::max(kGivenUp, share * share); }

double costOfGivingUp(const MatchGroup& group) {
  return fitted::kGivingUp * std::sqrt(double(group.edges.size()));
}

ById<MatchGroupId, double> beliefIn(const PoseGraph& graph, const NodePoses& poses,
                                    const PoseTolerance& within) {
  ById<MatchGroupId, double> belief;
  for (const MatchGroup& group : graph.groups) {
    double inliers = 0;
    for (const PoseEdgeId id : group.edges)
      inliers += isInlier(graph.edges[id], gapOf(graph.edges[id], poses), within);
    belief.add(beliefOf(inliers / double(group.edges.size())));
  }
  return belief;
}

double givenUpBetween(const PoseGraph& graph, const NodePoses& poses, RunId a, RunId b) {
  double all = 0, givenUp = 0;
  for (const MatchGroup& group : graph.groups) {
    if (std::minmax(group.from, group.to) != std::minmax(a, b)) continue;
    for (const PoseEdgeId id : group.edges) {
      const PoseEdge& edge = graph.edges[id];
      ++all, givenUp += !isInlier(edge, gapOf(edge, poses), kInlier);
    }
  }
  return all > 0 ? givenUp / all : 0;
}

double costOfDisbelief(const PoseGraph& graph, const ById<MatchGroupId, double>& belief) {
  double cost = 0;
  for (const MatchGroupId id : graph.groups.ids())
    cost += costOfGivingUp(graph.groups[id]) * (1 - belief[id]);
  return cost;
}

ById<RunId, double> runSlack(const PoseGraph& graph, const NodePoses& poses) {
  const ById<RunId, bool> isShared = haveSharedDrives(graph);
  ById<RunId, double> slack;
  double most = 0;  // of the runs without scans
  for (const GraphRun& run : graph.runs) {
    slack.add(meanStrain(graph, run, poses));
    if (!run.hasScans) most = std::max(most, *(slack.end() - 1));
  }
  for (const RunId run : graph.runs.ids()) {
    const double unit = !graph.runs[run].hasScans && most > 0 ? most : 1;
    const double least = isShared[run] ? fitted::kLeastSharedSlack : fitted::kLeastSlack;
    slack[run] = std::clamp(std::sqrt(slack[run] / unit), least, 1.0);
  }
  return slack;
}

}  // namespace roomgraph
