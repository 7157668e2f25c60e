#include "roomgraph/check/find_refuted.h"

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/check/beams_through_walls.h"

namespace roomgraph {
namespace {

/** What the beams of a run tell where the consensus has its scans, and what it has welded. */
struct BeamsOfRun {
  BeamsThroughWalls agreed;
  std::vector<WeldedPlace> welded;  ///< none if its error says that it is wrong
};

BeamsOfRun beamsOf(const Run& run, const std::vector<Transform2D>& agreed, const MapError& error) {
  const std::vector<LocalScan> scans = localScans(run.scans);
  BeamsOfRun beams{beamsThroughWalls(scans, agreed), {}};
  const bool mayBeApart = error.high >= kApartShift;
  if (error.error < (mayBeApart ? kApartShift : kBreakShift))
    beams.welded = findWelded(run, beamsThroughWalls(scans, drawnPoses(run.scans)), beams.agreed);
  return beams;
}

/** Whether there are others, and the beams of one run go through clearly more walls than theirs. */
bool standsOut(RunId one, const ById<RunId, BeamsOfRun>& beams) {
  bool hasOthers = false;
  for (const RunId other : beams.ids()) {
    if (other == one || !beams[other].agreed.share()) continue;
    if (!seesThroughMore(beams[other].agreed, beams[one].agreed)) return false;
    hasOthers = true;
  }
  return hasOthers;
}

}  // namespace

std::vector<WeldedKeyFrames> findRefuted(const Site& site, const Consensus& consensus,
                                         const ForEach& forEach) {
  ById<RunId, BeamsOfRun> beams(consensus.graph.runs.size());
  forEach(beams.size(), [&](std::size_t i) {
    const std::size_t siteRun = consensus.siteRuns[RunId(i)];
    const Run& run = *site.runs[siteRun];
    if (!run.scans.empty())
      beams[RunId(i)] = beamsOf(run, consensus.posesOf(siteRun), consensus.errorOf(siteRun));
  });
  std::vector<WeldedKeyFrames> refuted(site.runs.size());
  for (std::size_t i = 0; i < refuted.size(); ++i) {
    const RunId run = consensus.graphRuns[i];
    if (!run || run == consensus.graph.reference) continue;
    if (beams[run].welded.empty() || !standsOut(run, beams)) continue;
    const WeldedPlace& place = beams[run].welded.front();
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
