#include "ask_beams.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "roomgraph/check/beams_through_walls.h"

namespace roomgraph {
namespace {

/** What the beams of a run tell where the consensus has its scans, and what it has welded. */
struct BeamsOfRun {
  BeamsThroughWalls agreed;
  std::vector<WeldedPlace> welded;
};

BeamsOfRun beamsOf(const Run& run, const Consensus& consensus, RunId id) {
  std::vector<Transform2D> poses;
  for (const NodeId node : consensus.graph.runs[id].nodes) poses.push_back(consensus.poses[node]);
  const std::vector<LocalScan> scans = localScans(run.scans);
  BeamsOfRun beams{beamsThroughWalls(scans, poses), {}};
  beams.welded = findWelded(run, beamsThroughWalls(scans, drawnPoses(run.scans)), beams.agreed);
  return beams;
}

/** Whether the beams of one run go through clearly more walls than those of all others. */
bool standsOut(std::size_t one, const std::vector<std::optional<BeamsOfRun>>& beams) {
  for (std::size_t i = 0; i < beams.size(); ++i)
    if (i != one && beams[i] && beams[i]->agreed.share() &&
        !seesThroughMore(beams[i]->agreed, beams[one]->agreed))
      return false;
  return true;
}

}  // namespace

std::vector<WeldedKeyFrames> askBeams(const Site& site, const Consensus& consensus,
                                      RunScores& scores, const ForEach& forEach) {
  std::vector<std::optional<BeamsOfRun>> beams(site.runs.size());
  forEach(beams.size(), [&](std::size_t i) {
    if (!site.runs[i]->scans.empty() && consensus.isCounted(i))
      beams[i] = beamsOf(*site.runs[i], consensus, consensus.graphRuns[i]);
  });
  std::vector<WeldedKeyFrames> welded(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (!scores[i] || scores[i]->mapError >= kBreakShift) continue;
    if (!beams[i] || beams[i]->welded.empty() || !standsOut(i, beams)) continue;
    const WeldedPlace& place = beams[i]->welded.front();
    welded[i] = {place.one.keyFrame, place.other.keyFrame};
    scores[i].reset();
  }
  return welded;
}

}  // namespace roomgraph
