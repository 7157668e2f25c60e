#include "roomgraph/consensus/track_scans.h"

#include <algorithm>
#include <cmath>

#include "fitted_consensus.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/find_scan.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/step_hold.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"

namespace roomgraph {
namespace {

// Around a wall, of what counts in the fit of a scan. For the first half a part of its walls will
// do.
constexpr NarrowingBand kFit{0.6, 0.2, 6};
constexpr double kStartCost = 2 * fitted::kJumpCost;  // of a way that begins far from the whole
constexpr std::size_t kMostSpins = 3;  // scans looked for at any turn once one is lost
constexpr int kSpinTurns = 48;
constexpr Point kSpinOffsets[] = {{0, 0}, {0.7, 0}, {-0.7, 0}, {0, 0.7}, {0, -0.7}};

/** Says 0 where it is less than `least`, as soon as that is sure. */
double qualityAt(const ScanWalls& scan, const WallMap& map, const Transform2D& pose, double least,
                 double half = kWallCell, std::size_t stride = 1) {
  const double doubt = kDoubt / double(stride);
  const WallShare share = wallShare(
      scan.walls.size(), [&](std::size_t i) { return scan.walls[i]; }, map, pose, half, stride,
      least, doubt);
  return share.known * double(stride) >= double(LocalScan::kTelling) &&
                 share.known > kMajority * share.all
             ? share.ofKnown(doubt)
             : 0;
}

/** A pose that a scan may have, and the best way that leads there. */
struct Candidate {
  Transform2D pose;  // in <- run
  double quality = 0;
  double score = 0;  // of the whole way up to here
  const Candidate* before = nullptr;
  std::size_t scan = 0;
};

/** The likeliest way of a run's scans through another map (Viterbi 1967): each scan has a few
 *  candidate poses, or none; poses that fit gain, jumps from scan to scan cost. */
class Tracker {
 public:
  Tracker(const std::vector<ScanWalls>& scans, const WallPatches& patches,
          const FollowedWalls& followed, const LikelyPoses& likely, const WallMap& map,
          TrackedFits& fits)
      : scans_(scans),
        patches_(patches),
        followed_(followed),
        likely_(likely),
        map_(map),
        fits_(fits),
        candidates_(scans.size()),
        holds_(scans.size()) {
    fits_.resize(scans.size());
  }

  std::vector<std::optional<Transform2D>> track() {
    for (std::size_t k = 0; k < scans_.size(); ++k) propose(k, Way::forth);
    for (std::size_t k = scans_.size(); k-- > 0;) propose(k, Way::back);
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      if (k > fitted::kMemory) forget(k - fitted::kMemory - 1);
      for (Candidate& candidate : candidates_[k]) link(candidate);
    }
    const Candidate* last = nullptr;
    for (const auto& ofScan : candidates_)
      for (const Candidate& candidate : ofScan)
        if (!last || candidate.score > last->score) last = &candidate;
    std::vector<std::optional<Transform2D>> poses(scans_.size());
    if (last && last->score > 0)
      for (; last; last = last->before) poses[last->scan] = last->pose;
    return poses;
  }

 private:
  enum class Way { forth, back };

  /** Finds candidates of a scan: near those of the scans before it on the way, near what was
   *  followed, and, where all that fails, at any turn where the robot has just been. */
  void propose(std::size_t k, Way way) {
    if (scans_[k].walls.size() < LocalScan::kTelling) return;
    const std::vector<Candidate>* before = lastFound(k, way);
    if (before)
      for (const Candidate& candidate : std::vector<Candidate>(*before)) tryFrom(k, candidate.pose);
    if (way == Way::forth && bestQuality(k) < fitted::kSure) {
      for (const Transform2D& pose : posesNear(scans_[k].robot())) tryFrom(k, pose);
      tryLikely(k, likely_.whole);
      tryLikely(k, likely_.lost);
    }
    if (before && bestQuality(k) < fitted::kWell && isJustLost(k, before->front()))
      spin(k, before->front());
    auto& found = candidates_[k];
    sortDownBy(found, &Candidate::quality);
    if (found.size() > fitted::kCandidates) found.resize(fitted::kCandidates);
  }

  bool isJustLost(std::size_t k, const Candidate& last) const {
    const std::size_t since = k > last.scan ? k - last.scan : last.scan - k;
    return last.quality >= fitted::kWell && since <= kMostSpins;
  }

  double bestQuality(std::size_t k) const {
    double best = 0;
    for (const Candidate& candidate : candidates_[k]) best = std::max(best, candidate.quality);
    return best;
  }

  /** The candidates of the last scan on the way that has any good one, not too long ago. */
  const std::vector<Candidate>* lastFound(std::size_t k, Way way) const {
    const std::size_t left = way == Way::forth ? k : scans_.size() - 1 - k;
    const std::vector<Candidate>* any = nullptr;
    for (std::size_t back = 1; back <= std::min(left, fitted::kMemory); ++back) {
      const auto& found = candidates_[way == Way::forth ? k - back : k + back];
      if (!found.empty() && found.front().quality >= fitted::kWell) return &found;
      if (!any && !found.empty()) any = &found;
    }
    return any;
  }

  bool isKnown(std::size_t k, const Transform2D& pose, const PoseTolerance& within) const {
    return anyOf(candidates_[k], [&](const Candidate& c) {
      return areNear(c.pose, pose, scans_[k].robot(), within);
    });
  }

  void tryLikely(std::size_t k, const std::vector<Transform2D>& poses) {
    for (const Transform2D& pose : poses)
      if (!isKnown(k, pose, kSameScanStart) &&
          roughQualityAt(k, pose, fitted::kLeastQuality) >= fitted::kLeastQuality)
        tryFrom(k, pose);
  }

  void tryFrom(std::size_t k, const Transform2D& start) {
    if (isKnown(k, start, kSameScanStart)) return;
    TrackedFit& fit = fitFrom(k, start);
    if (fit.roughQuality < fitted::kLeastQuality || isKnown(k, fit.rough, kSameScanAnswer)) return;
    if (!fit.quality) {
      fit.pose = fitted(scans_[k], fit.rough, kFit.half(1), 1);
      fit.quality = qualityAt(scans_[k], map_, fit.pose, fitted::kLeastQuality);
    }
    if (*fit.quality < fitted::kLeastQuality || isKnown(k, fit.pose, kSameScanAnswer)) return;
    candidates_[k].push_back({fit.pose, *fit.quality, 0, nullptr, k});
  }

  /** What a scan comes to from a start, roughly; found once. */
  TrackedFit& fitFrom(std::size_t k, const Transform2D& start) {
    for (TrackedFit& fit : fits_[k])
      if (fit.start.x == start.x && fit.start.y == start.y && fit.start.phi == start.phi)
        return fit;
    TrackedFit fit;
    fit.start = start;
    fit.rough = fitted(scans_[k], start, kFit.half(0), kQuickStride);
    fit.roughQuality = roughQualityAt(k, fit.rough, fitted::kLeastQuality);
    fits_[k].push_back(fit);
    return fits_[k].back();
  }

  /** Tries all turns about the place where the robot was last seen: a map that is torn there goes
   *  on from the same place, but turned and shifted. */
  void spin(std::size_t k, const Candidate& last) {
    const Point place = last.pose(scans_[last.scan].robot());
    std::vector<std::pair<double, Transform2D>> tries;
    for (int turn = 0; turn < kSpinTurns; ++turn)
      for (const Point off : kSpinOffsets) {
        const double phi = last.pose.phi + turn * 2 * M_PI / kSpinTurns;
        const Transform2D pose = carrying(scans_[k].robot(), place + off, phi);
        const double least = tries.size() < kTries ? 0 : tries.back().first;
        const double quality = roughQualityAt(k, pose, least);
        if (tries.size() == kTries && quality <= least) continue;
        tries.insert(std::find_if(tries.begin(), tries.end(),
                                  [&](const auto& one) { return one.first < quality; }),
                     {quality, pose});
        tries.resize(std::min(tries.size(), kTries));
      }
    for (const auto& [quality, pose] : tries) tryFrom(k, pose);
  }

  /** What a pose that is some decimetres off may come to, by a part of the walls. */
  double roughQualityAt(std::size_t k, const Transform2D& pose, double least) const {
    return qualityAt(scans_[k], map_, pose, least, kSameWhereBent,
                     roughStride(scans_[k].walls.size()));
  }

  Transform2D fitted(const ScanWalls& scan, const Transform2D& pose, const NarrowingBand& band,
                     std::size_t stride) const {
    return fittedPose(pose, scan.robot(), band, [&](WallFit& fit, int) {
      for (std::size_t w = 0; w < scan.walls.size(); w += stride) fit.add(scan.walls[w], map_);
    });
  }

  /** What was followed near a place, alike poses once. */
  std::vector<Transform2D> posesNear(Point place) const {
    std::vector<Transform2D> poses;
    for (const FollowedPatch& f : followed_.patches) {
      if (distance(patches_[f.patch].middle, place) > kPatchReach) continue;
      if (!isNearAny(poses, f.pose, place, kSameScanStart)) poses.push_back(f.pose);
    }
    return poses;
  }

  /** What it costs to go from one candidate to one of a later scan. */
  double stepCost(const Candidate& from, const Candidate& to) const {
    const Point place = scans_[to.scan].robot();
    const double moved = distance(from.pose(place), to.pose(place));
    const double turned = std::abs(wrappedAngle(from.pose.phi - to.pose.phi));
    const double bend = moved / kSteadyTrack.place + turned / kSteadyTrack.turn;
    constexpr double kMostBend = fitted::kJumpCost / 4;
    if (bend < 1) return kMostBend * bend * bend;
    const double way = distance(from.pose(scans_[from.scan].robot()), to.pose(place));
    const bool isOnTheWay = way <= fitted::kScanStride * double(to.scan - from.scan);
    const bool isLookedFor = isNearAny(likely_.lost, to.pose, place, kRoughly);
    if (isOnTheWay && !isLookedFor) return fitted::kJumpCost;
    // Where the run's own scans part, to go on where it was looked for costs little more than a
    // bend does, and to begin anew than a start.
    const double hold = holdBetween(from.scan, to.scan);
    return isOnTheWay ? hold * fitted::kJumpCost + (1 - hold) * kMostBend
                      : hold * fitted::kFarCost + (1 - hold) * kStartCost;
  }

  /** How far the run's own scans hold together from one scan to another. */
  double holdBetween(std::size_t from, std::size_t to) const {
    double least = 1;
    for (std::size_t k = from + 1; k <= to; ++k) {
      if (!holds_[k]) holds_[k] = stepHold(scans_, k);
      least = std::min(least, *holds_[k]);
    }
    return least;
  }

  /** Of the ways that end at a scan which is out of memory, only the best is gone on from. */
  void forget(std::size_t k) {
    for (const Candidate& from : candidates_[k])
      if (!best_ || from.score > best_->score) best_ = &from;
  }

  /** Finds the best way to a candidate. */
  void link(Candidate& to) {
    const double gain = to.quality - fitted::kLeastQuality;
    to.score = gain - (to.scan > 0 && best_ ? fitted::kFarCost : startCost(to));
    const auto offer = [&](const Candidate& from, double cost) {
      if (from.score - cost + gain <= to.score) return;
      to.score = from.score - cost + gain;
      to.before = &from;
    };
    for (std::size_t back = 1; back <= std::min(to.scan, fitted::kMemory); ++back)
      for (const Candidate& from : candidates_[to.scan - back]) offer(from, stepCost(from, to));
    if (best_) offer(*best_, std::min(fitted::kFarCost, stepCost(*best_, to)));
  }

  /** A way starts where the maps as a whole fit. */
  double startCost(const Candidate& first) const {
    const bool isMain =
        areNear(first.pose, likely_.whole.front(), scans_[first.scan].robot(), kAsMapsBend);
    return isMain ? 0 : kStartCost;
  }

  const std::vector<ScanWalls>& scans_;
  const WallPatches& patches_;
  const FollowedWalls& followed_;
  const LikelyPoses& likely_;
  const WallMap& map_;
  TrackedFits& fits_;
  std::vector<std::vector<Candidate>> candidates_;
  mutable std::vector<std::optional<double>> holds_;  // of the step to each scan, once it was asked
  const Candidate* best_ = nullptr;                   // of the scans that are out of memory
};

}  // namespace

std::vector<std::optional<Transform2D>> trackScans(const std::vector<ScanWalls>& scans,
                                                   const WallPatches& patches,
                                                   const FollowedWalls& followed,
                                                   const LikelyPoses& likely, const WallMap& map,
                                                   TrackedFits& fits) {
  return Tracker(scans, patches, followed, likely, map, fits).track();
}

}  // namespace roomgraph
