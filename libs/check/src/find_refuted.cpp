#include "roomgraph/check/find_refuted.h"

#include "roomgraph/base/sentence_text.h"
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

std::vector<WeldedKeyFrames> findRefuted(const Site& site, const Consensus& consensus,
                                         const ForEach& forEach) {
  std::vector<std::optional<BeamsOfRun>> beams(site.runs.size());
  forEach(beams.size(), [&](std::size_t i) {
    if (!site.runs[i]->scans.empty() && consensus.isCounted(i))
      beams[i] = beamsOf(*site.runs[i], consensus, consensus.graphRuns[i]);
  });
  std::vector<WeldedKeyFrames> refuted(beams.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (i == site.reference || !beams[i] || beams[i]->welded.empty()) continue;
    if (consensus.errorOf(i).error >= kBreakShift || !standsOut(i, beams)) continue;
    const WeldedPlace& place = beams[i]->welded.front();
    refuted[i] = {place.one.keyFrame, place.other.keyFrame};
  }
  return refuted;
}

std::string weldedText(const std::pair<std::size_t, std::size_t>& keyFrames) {
  return formatted(
      "has drawn key frames %zu and %zu at one place, though they see through each other's walls",
      keyFrames.first, keyFrames.second);
}

}  // namespace roomgraph
