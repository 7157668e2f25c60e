#include "coarse_graph.h"

#include <utility>

#include "roomgraph/align/near_poses.h"

namespace roomgraph {
namespace {

constexpr std::uint32_t kMostInNode = 4;  // key frames

/** Where a piece has its run (in <- of), by one of its matches. */
Transform2D placeBy(const RunMatches& piece, const SubmapMatch& match,
                    const std::vector<RunSubmaps>& runs) {
  return runs[piece.in].submaps[match.in].pose * match.pose *
         runs[piece.of].submaps[match.submap].pose.inverse();
}

/** For each submap of each run whether a node has to start with it: a piece begins there, or has
 *  ended just before, or finds it otherwise than the submap before. */
std::vector<std::vector<bool>> nodeStarts(const std::vector<RunSubmaps>& runs,
                                          const std::vector<RunMatches>& matches) {
  std::vector<std::vector<bool>> startsNode;
  for (const RunSubmaps& run : runs) startsNode.emplace_back(run.submaps.size() + 1);
  for (const RunMatches& piece : matches) {
    if (piece.matches.empty()) continue;
    startsNode[piece.of][piece.matches.front().submap] = true;
    startsNode[piece.of][piece.matches.back().submap + 1] = true;
    for (std::size_t m = 1; m < piece.matches.size(); ++m) {
      const SubmapMatch &before = piece.matches[m - 1], &now = piece.matches[m];
      const Point at = runs[piece.of].submaps[now.submap].pose.shift();
      if (areNear(placeBy(piece, before, runs), placeBy(piece, now, runs), at, kSameNode)) continue;
      startsNode[piece.of][before.submap + 1] = startsNode[piece.of][now.submap] = true;
      // Other pieces are found both ways, each by itself.
      if (now.isSameScan) startsNode[piece.in][before.in + 1] = startsNode[piece.in][now.in] = true;
    }
  }
  return startsNode;
}

/** What `run` is as a coarse run; tells of each of its submaps which one that is. */
RunSubmaps coarseRun(const RunSubmaps& run, const std::vector<bool>& startsNode,
                     std::vector<std::uint32_t>& nodeOf) {
  RunSubmaps coarse;
  coarse.areScans = run.areScans;
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < run.submaps.size(); ++k, ++count) {
    if (k == 0 || !run.areScans || startsNode[k] || count == kMostInNode)
      coarse.submaps.push_back(run.submaps[k]), count = 0;
    nodeOf.push_back(std::uint32_t(coarse.submaps.size() - 1));
  }
  for (const SubmapLink& link : run.links)
    if (nodeOf[link.from] != nodeOf[link.to])
      coarse.links.push_back({nodeOf[link.from], nodeOf[link.to]});
  return coarse;
}

}  // namespace

CoarseGraph coarseGraph(const std::vector<RunSubmaps>& runs,
                        const std::vector<RunMatches>& matches) {
  CoarseGraph coarse{{}, matches, std::vector<std::vector<std::uint32_t>>(runs.size())};
  const auto startsNode = nodeStarts(runs, matches);
  for (std::size_t r = 0; r < runs.size(); ++r)
    coarse.runs.push_back(coarseRun(runs[r], startsNode[r], coarse.nodeOf[r]));
  // node <- submap, by the run's own poses
  const auto inNode = [&](std::size_t r, std::uint32_t k) {
    return coarse.runs[r].submaps[coarse.nodeOf[r][k]].pose.inverse() * runs[r].submaps[k].pose;
  };
  for (RunMatches& piece : coarse.matches)
    for (SubmapMatch& match : piece.matches) {
      match.pose =
          inNode(piece.in, match.in) * match.pose * inNode(piece.of, match.submap).inverse();
      match.in = coarse.nodeOf[piece.in][match.in];
      match.submap = coarse.nodeOf[piece.of][match.submap];
    }
  return coarse;
}

SubmapPoses coarsePoses(const CoarseGraph& coarse, const SubmapPoses& poses) {
  SubmapPoses result(poses.size());
  for (std::size_t r = 0; r < poses.size(); ++r)
    for (std::size_t k = 0; k < poses[r].size(); ++k)
      if (coarse.nodeOf[r][k] == result[r].size()) result[r].push_back(poses[r][k]);
  return result;
}

SubmapPoses finePoses(const CoarseGraph& coarse, const SubmapPoses& shape,
                      const SubmapPoses& poses) {
  const SubmapPoses first = coarsePoses(coarse, shape);
  SubmapPoses result(shape.size());
  for (std::size_t r = 0; r < shape.size(); ++r)
    for (std::size_t k = 0; k < shape[r].size(); ++k) {
      const std::uint32_t node = coarse.nodeOf[r][k];
      result[r].push_back(poses[r][node] * first[r][node].inverse() * shape[r][k]);
    }
  return result;
}

}  // namespace roomgraph
