#include "roomgraph/repair/repair_runs.h"

#include <algorithm>
#include <cmath>

#include "OtherWalls.h"
#include "fitted_repair.h"
#include "moved_run.h"
#include "roomgraph/base/majority.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/consensus/pose_covariances.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

/** Why a run is better left as it was; mended where nothing speaks for that. */
void judge(const MapError& error, RepairedRun& repaired) {
  if (!isTrusted(error)) {
    repaired.reason =
        formatted("left as it was: others have seen only %.0f %% of it", 100 * error.seen);
  } else if (error.low <= 0) {
    repaired.reason = formatted("left as it was: its error of %.3f m may be none", error.error);
  } else {
    repaired.state = RepairState::mended;
    repaired.reason =
        formatted("mended: it was %.3f m off (%.3f to %.3f)", error.error, error.low, error.high);
  }
}

/** Whether the scans of a run fit better on what others have seen where they really lie than as the
 *  run has them, laid over that. */
bool fitsBetter(const SolvedSite& solved, const std::vector<Transform2D>& real, std::size_t i,
                const Transform2D& siteOfRun) {
  const std::vector<LocalScan> scans = localScans(solved.site.runs[i]->scans);
  std::vector<Point> places;
  const std::size_t step = scans.size() / fitted::kProbes + 1;
  for (std::size_t k = 0; k < scans.size(); k += step) {
    places.push_back(real[k].shift());
    places.push_back((siteOfRun * solved.site.runs[i]->scans[k].pose).shift());
  }
  const OtherWalls walls(solved, i, places);
  double before = 0, after = 0;
  for (std::size_t k = 0; k < scans.size(); k += step) {
    before += walls.scoreAt(scans[k], siteOfRun * solved.site.runs[i]->scans[k].pose);
    after += walls.scoreAt(scans[k], real[k]);
  }
  return after > before;
}

RepairedRun repairedRun(const SolvedSite& solved, const std::vector<Transform2D>& real,
                        std::size_t i) {
  const Run& run = *solved.site.runs[i];
  RepairedRun repaired;
  repaired.run = solved.site.members[i], repaired.siteRun = i;
  repaired.poses = drawnPoses(run.scans);
  repaired.frame = soundFrame(repaired.poses, real);
  repaired.unseen = unseenIn(run, solved.consensus.errorOf(i).isSeen);
  if (solved.site.reference == i) {
    repaired.state = RepairState::reference, repaired.reason = "the reference, left as it was";
    return repaired;
  }
  judge(solved.consensus.errorOf(i), repaired);
  if (repaired.state != RepairState::mended) return repaired;
  if (!fitsBetter(solved, real, i, repaired.frame.inverse())) {
    repaired.state = RepairState::kept;
    repaired.reason = "left as it was: moved, it would fit what the others have seen no better";
    return repaired;
  }
  moveTo(real, run, repaired);
  return repaired;
}

/** Says how sure the poses of mended runs are. */
void tellCovariances(const Consensus& consensus, std::vector<RepairedRun>& all) {
  std::vector<RepairedRun*> mended;
  std::vector<RunId> runs;
  for (RepairedRun& repaired : all) {
    if (repaired.state != RepairState::mended) continue;
    mended.push_back(&repaired);
    runs.push_back(consensus.graphRuns[repaired.siteRun]);
  }
  const auto covariances = poseCovariances(consensus.graph, consensus.trust, consensus.poses, runs);
  for (std::size_t i = 0; i < mended.size(); ++i)
    for (const PlanarCovariance& sure : covariances[i])
      mended[i]->covariances.push_back(turned(sure, mended[i]->frame.phi));
}

}  // namespace

bool isTrusted(const MapError& error) { return error.seen >= kMajority; }

std::vector<RepairedRun> repairRuns(const SolvedSite& solved, const RealPoses& real) {
  std::vector<RepairedRun> all;
  for (std::size_t i = 0; i < solved.site.runs.size(); ++i)
    if (!solved.site.runs[i]->scans.empty()) all.push_back(repairedRun(solved, real[i], i));
  tellCovariances(solved.consensus, all);
  return all;
}

}  // namespace roomgraph
