#include "roomgraph/repair/repair_runs.h"

#include <cmath>

#include "OtherWalls.h"
#include "fitted_repair.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/check/find_refuted.h"
#include "roomgraph/consensus/pose_covariances.h"
#include "roomgraph/repair/sound_frame.h"

namespace roomgraph {
namespace {

// Parts of a repair that are the same with other runs and alone.

/** Stretches of scans that were not seen at another time, or by another run. */
std::vector<KeyFrames> unseenIn(const Run& run, const std::vector<bool>& isSeen) {
  std::vector<KeyFrames> stretches;
  for (std::size_t k = 0; k < run.scans.size(); ++k) {
    if (isSeen[k]) continue;
    if (k == 0 || isSeen[k - 1]) stretches.push_back({run.scans[k].keyFrame, 0});
    stretches.back().to = run.scans[k].keyFrame;
  }
  return stretches;
}

/** Moves the scans of a run to `real` (site <- robot) by `repaired.frame`, and tells how far. */
void moveTo(const std::vector<Transform2D>& real, const Run& run, RepairedRun& repaired) {
  double squares = 0;
  for (std::size_t k = 0; k < real.size(); ++k) {
    repaired.poses[k] = repaired.frame * real[k];
    const double apart = poseDistance(run.scans[k].pose, repaired.poses[k]);
    squares += apart * apart;
    if (apart <= repaired.movedMost) continue;
    repaired.movedMost = apart, repaired.movedMostAt = run.scans[k].keyFrame;
  }
  repaired.moved = std::sqrt(squares / double(real.size()));
}

/** A covariance along axes that are turned by `angle` from those that it is along [rad]. */
PlanarCovariance turnedCovariance(const PlanarCovariance& covariance, double angle) {
  const auto& [xx, yy, pp, xy, xp, yp] = covariance;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * xx - 2 * c * s * xy + s * s * yy,
          s * s * xx + 2 * c * s * xy + c * c * yy,
          pp,
          c * s * (xx - yy) + (c * c - s * s) * xy,
          c * xp - s * yp,
          s * xp + c * yp};
}

/** Why a run is better left as it was; mended where nothing speaks for that. */
void judge(const RunCheck& check, RepairedRun& repaired) {
  if (!check.selfError) {
    repaired.reason = "left as it was: " + check.sentence;
  } else if (check.low <= 0 && check.breaks.empty()) {
    repaired.reason =
        formatted("left as it was: its self error of %.3f m may be zero", *check.selfError);
  } else {
    repaired.state = RepairState::mended;
    repaired.reason = formatted("mended: its self error was %.3f m (%.3f to %.3f)",
                                *check.selfError, check.low, check.high);
  }
}

/** Why a run is better left as it was; mended where nothing speaks for that. */
void judge(const MapError& error, const WeldedKeyFrames& welded, RepairedRun& repaired) {
  if (welded) {
    repaired.reason = "left as it was: it " + weldedText(*welded);
  } else if (!isTrusted(error)) {
    repaired.reason =
        formatted("left as it was: others have seen only %.0f %% of it", 100 * error.seen);
  } else if (error.low <= 0) {
    repaired.reason = formatted("left as it was: its error of %.3f m may be zero", error.error);
  } else if (fitsInTwoWays(error)) {
    repaired.reason =
        formatted("left as it was: it fits the others in two ways, and may be %.3f m or %.3f m off",
                  error.low, error.error);
  } else {
    repaired.state = RepairState::mended;
    repaired.reason =
        formatted("mended: it was %.3f m off (%.3f to %.3f)", error.error, error.low, error.high);
  }
}

/** How some scans of a run fit on what the others have drawn. */
struct RunFit {
  double score = 0, squares = 0;  // of how far scans lie from where they fit, summed up [m^2]
  std::size_t found = 0;          // scans that fit near where they lie

  double apart() const { return std::sqrt(squares / double(found)); }
};

RunFit fitOf(const OtherWalls& walls, const std::vector<LocalScan>& scans,
             const std::vector<Transform2D>& poses) {
  RunFit fit;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    fit.score += walls.at(scans[k], poses[k]).score;
    const ScanFit near = walls.near(scans[k], poses[k]);
    if (near.quality <= kFairQuality) continue;
    const double apart = poseDistance(poses[k], near.pose);
    fit.squares += apart * apart, ++fit.found;
  }
  return fit;
}

/** Whether more scans fit, or the same ones lie clearly nearer to where they fit: key frames that
 *  are off each on its own stay so, however the run is bent. */
bool isBetter(const RunFit& after, const RunFit& before) {
  if (after.score <= before.score || after.found == 0) return false;
  const bool areMore = double(before.found) < kRivalScore * double(after.found);
  return areMore || after.apart() <= kRivalScore * before.apart();
}

/** Which scans lie elsewhere than they were drawn, by more than one wall in two maps: of a torn end
 *  only a few. All, where none do. */
std::vector<std::size_t> movedScans(const std::vector<Transform2D>& drawn,
                                    const std::vector<Transform2D>& real) {
  std::vector<std::size_t> moved;
  for (std::size_t k = 0; k < drawn.size(); ++k)
    if (poseDistance(drawn[k], real[k]) > kSameWall) moved.push_back(k);
  return moved.empty() ? numbersFrom(0, drawn.size()) : moved;
}

/** How far scans of a run lie from where they fit on what others have seen, once they are where
 *  they really lie [m]; nothing if they fit there no better than as the run has them, laid over
 *  that. */
std::optional<double> leftOf(const SolvedSite& solved, const std::vector<Transform2D>& real,
                             std::size_t i, const Transform2D& siteOfRun) {
  const std::vector<ScanWalls>& all = solved.site.runs[i]->scans;
  const auto laid = mapped(all, [&](const ScanWalls& scan) { return siteOfRun * scan.pose; });
  const std::vector<std::size_t> elsewhere = movedScans(laid, real);
  std::vector<ScanWalls> probes;
  std::vector<Transform2D> drawn, moved;
  std::vector<Point> places;
  for (std::size_t n = 0; n < elsewhere.size(); n += elsewhere.size() / fitted::kProbes + 1) {
    const std::size_t k = elsewhere[n];
    probes.push_back(all[k]);
    drawn.push_back(laid[k]), moved.push_back(real[k]);
    places.push_back(drawn.back().shift()), places.push_back(moved.back().shift());
  }
  const std::vector<LocalScan> scans = localScans(probes);
  const OtherWalls walls(solved, i, places);
  const RunFit after = fitOf(walls, scans, moved);
  if (!isBetter(after, fitOf(walls, scans, drawn))) return std::nullopt;
  return after.apart();
}

RepairedRun repairedRun(const SolvedSite& solved, const std::vector<Transform2D>& real,
                        const WeldedKeyFrames& welded, std::size_t i) {
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
  judge(solved.consensus.errorOf(i), welded, repaired);
  if (repaired.state != RepairState::mended) return repaired;
  repaired.left = leftOf(solved, real, i, repaired.frame.inverse());
  if (!repaired.left) {
    repaired.state = RepairState::kept;
    repaired.reason =
        "left as it was: moving it would not improve its fit to what the others have seen";
    return repaired;
  }
  repaired.reason += formatted(", now %.3f m from where its scans fit", *repaired.left);
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
      mended[i]->covariances.push_back(turnedCovariance(sure, mended[i]->frame.phi));
}

}  // namespace

bool isTrusted(const MapError& error) {
  return error.seen >= kMajority || (error.seen > 0 && error.high < kBreakShift);
}

bool fitsInTwoWays(const MapError& error) {
  return error.error >= kBreakShift && error.low * fitted::kTwoWays < error.error;
}

std::vector<RepairedRun> repairRuns(const SolvedSite& solved, const RealPoses& real) {
  const auto refuted = findRefuted(solved.site, solved.consensus, oneByOne);
  std::vector<RepairedRun> all;
  for (std::size_t i = 0; i < solved.site.runs.size(); ++i)
    if (!solved.site.runs[i]->scans.empty())
      all.push_back(repairedRun(solved, real[i], refuted[i], i));
  tellCovariances(solved.consensus, all);
  return all;
}

RepairedRun repairAlone(const Run& run, const RunCheck& check) {
  RepairedRun repaired;
  repaired.poses = drawnPoses(run.scans);
  const std::vector<Transform2D> agreed = agreedPoses(check);
  repaired.frame = soundFrame(repaired.poses, agreed);
  repaired.unseen = unseenIn(run, mapped(check.path, &CheckedPose::isSeenTwice));
  judge(check, repaired);
  if (repaired.state == RepairState::mended) moveTo(agreed, run, repaired);
  return repaired;
}

}  // namespace roomgraph
