#include "roomgraph/consensus/mend_steps.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "fitted_consensus.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/consensus/scans_of_step.h"

namespace roomgraph {
namespace {

/** Whether a step by which the scans fit so much better is wrong as it was drawn. */
bool refutes(const fitted::Contradiction& by, const ScanFit& drawn, const ScanFit& found) {
  return drawn.quality < by.mostAsDrawn && found.quality > by.leastElsewhere &&
         found.score - drawn.score > by.leastGain;
}

class Mender {
 public:
  Mender(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
         const std::vector<bool>& asked)
      : scans_(scans),
        drawn_(drawn),
        asked_(asked),
        gait_(drawn, mapped(scans, &LocalScan::time)),
        sides_(scans, drawn, gait_) {}

  MendedSteps mended() {
    result_.poses = drawn_;
    result_.evidence.assign(drawn_.size(), StepEvidence::none);
    for (std::size_t k = 1; k < drawn_.size(); ++k) {
      mend(k);
      if (isAsked(k) && result_.evidence[k] != StepEvidence::contradicts) lookBack(k);
    }
    return std::move(result_);
  }

 private:
  bool isAsked(std::size_t k) const { return asked_.empty() || asked_[k]; }

  bool isPossible(std::size_t k) const { return gait_.isPossible(sides_.step(k - 1, k), k); }

  void mend(std::size_t k) {
    // As drawn to the last bit, up to the first contradiction.
    result_.poses[k] = isMended_ ? result_.poses[k - 1] * sides_.step(k - 1, k) : drawn_[k];
    if (!isAsked(k) || !scans_[k].isTelling()) return;
    if (ahead_.walls.empty() || k >= aheadOf_ + ScansOfStep::kTogether) drawAhead(k);
    if (ahead_.walls.empty()) return;
    const ScanFit fit = asDrawn(scans_[k], ahead_, result_.poses[k]);
    if (fit.quality >= fitted::kWell) {
      result_.evidence[k] = StepEvidence::agrees;
      return;
    }
    if (aheadOf_ != k) drawAhead(k);
    result_.evidence[k] = judge(k);
    if (result_.evidence[k] != StepEvidence::lost) return;
    ahead_ = sides_.around(k, result_.poses);
    result_.evidence[k] = judge(k);
    ahead_.walls.clear();  // of the steps behind those before it tell more
  }

  void drawAhead(std::size_t k) {
    ahead_ = sides_.ahead(k, result_.poses);
    aheadOf_ = k;
  }

  /** Holds the one scan before a step against those behind it. A scan that lies wrong on its own
   *  is not seen by judge(), which takes it together with others that lie right. */
  void lookBack(std::size_t k) {
    const LocalScan& scan = scans_[k - 1];
    if (!scan.isTelling()) return;
    const WallMap& behind = sides_.behind(k);
    if (behind.walls.empty()) return;
    const Transform2D back = result_.poses[k].inverse() * result_.poses[k - 1];
    const ScanFit drawn = asDrawn(scan, behind, back);
    if (drawn.known < fitted::kMaySpeak || drawn.quality + fitted::kClearerBehind > 1) return;
    const std::vector<ScanFit> found = findScan(scan, behind, back, fitted::kSlipped, 2);
    const auto best = bestOf(found);
    if (best == found.end() || areNear(best->pose, back, {}, kAsDrawn)) return;
    const double gain = best->score - drawn.score;
    if (mendTurn(k, best->pose, gain)) return;
    const bool mayBe = areNear(best->pose, back, {}, fitted::kSlipped) ||
                       drawn.quality < fitted::kTear.mostAsDrawn;
    if (!mayBe || best->quality < kMajority ||
        best->quality < drawn.quality + fitted::kClearerBehind || gain < fitted::kGainBehind ||
        secondOf(found, *best, drawn) - drawn.score > kRivalScore * gain)
      return;
    mendBack(k, behind, best->pose);
  }

  /** Where scans on either side of a step, each for itself, are turned alike against what was
   *  drawn. Shifts do not count: scans slide along a corridor on both sides alike, and turn as they
   *  slide where it is bent. `pose`: of scan k - 1 in scan k, which fits by `gain` better so.
   *  Returns false where they are not. */
  bool mendTurn(std::size_t k, const Transform2D& pose, double gain) {
    const Transform2D slipped = result_.poses[k - 1] * pose.inverse();
    const Transform2D alone = result_.poses[k] * pose;
    if (turnedGain(k, slipped) + gain > fitted::kSlip.leastGain) {
      result_.evidence[k] = mendTo(k, slipped);
    } else if (turnedGain(k - 1, alone) + gain > fitted::kSlip.leastGain) {
      mendAlone(k - 1, alone);
    } else {
      return false;
    }
    return true;
  }

  /** By how much better a scan fits what those before it have drawn, if it does so best where it
   *  is turned about as in `pose`; else far less than nothing. */
  double turnedGain(std::size_t k, const Transform2D& pose) const {
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    const Transform2D& as = result_.poses[k];
    const auto isTurned = [&](const Transform2D& other) {
      const double turn = std::abs(wrappedAngle(other.phi - as.phi));
      const double shift = distance(other.shift(), as.shift());
      return turn > kAsDrawn.turn && turn / fitted::kSlipped.turn > shift / fitted::kSlipped.place;
    };
    if (!isTurned(pose) || !scans_[k].isTelling()) return kNone;
    const WallMap ahead = sides_.ahead(k, result_.poses);
    if (ahead.walls.empty()) return kNone;
    const std::vector<ScanFit> found = findScan(scans_[k], ahead, as, fitted::kSlipped, 2);
    const auto best = bestOf(found);
    if (best == found.end() || !isTurned(best->pose) ||
        !areNear(best->pose, pose, {}, kSameScanStart))
      return kNone;
    return best->score - asDrawn(scans_[k], ahead, as).score;
  }

  /** Either the run slips between the two scans or, if the one before fits to those behind as it
   *  was drawn, only the scan between lies wrong. `pose`: of scan k - 1 in scan k. */
  void mendBack(std::size_t k, const WallMap& behind, const Transform2D& pose) {
    if (k > 1 && result_.evidence[k - 1] != StepEvidence::contradicts) {
      const Transform2D before = result_.poses[k - 1].inverse() * result_.poses[k - 2];
      const Transform2D back = result_.poses[k].inverse() * result_.poses[k - 1];
      const ScanFit drawn = asDrawn(scans_[k - 2], behind, back * before);
      if (drawn.score >= asDrawn(scans_[k - 2], behind, pose * before).score) {
        const Transform2D mended = result_.poses[k] * pose;
        if (!gait_.isLikely(result_.poses[k - 2].inverse() * mended, k - 1)) return;
        return mendAlone(k - 1, mended);
      }
    }
    result_.evidence[k] = mendTo(k, result_.poses[k - 1] * pose.inverse());
  }

  /** The score of the next best pose, or of that which was drawn. */
  static double secondOf(const std::vector<ScanFit>& found, const ScanFit& best,
                         const ScanFit& drawn) {
    double second = drawn.score;
    for (const ScanFit& fit : found)
      if (!areNear(fit.pose, best.pose, {}, kSameScanStart)) second = std::max(second, fit.score);
    return second;
  }

  /** The pose that fits best, or one near to where it was drawn, `as`, that fits about as well:
   *  runs slip more often than they tear. */
  static Transform2D nearerOne(const std::vector<ScanFit>& found, const ScanFit& best,
                               const ScanFit& drawn, const Transform2D& as) {
    const double least = drawn.score + kRivalScore * (best.score - drawn.score);
    const ScanFit* nearer = nullptr;
    for (const ScanFit& fit : found)
      if (fit.score >= least && areNear(fit.pose, as, {}, fitted::kSlipped) &&
          (!nearer || fit.score > nearer->score))
        nearer = &fit;
    return nearer ? nearer->pose : best.pose;
  }

  StepEvidence judge(std::size_t k) {
    const StepView view = sides_.view(k, result_.poses);
    const ScanFit drawn = sides_.weighed(k, view, asDrawn(view.after, ahead_, result_.poses[k]));
    if (isPossible(k) && drawn.quality >= fitted::kSlip.mostAsDrawn)
      return drawn.quality >= kMajority ? StepEvidence::agrees : StepEvidence::none;
    const bool mayBeTorn = !isPossible(k) || drawn.quality < fitted::kTear.mostAsDrawn;
    const auto weighed = [&](const ScanFit& fit) { return sides_.weighed(k, view, fit); };
    return decide(k, drawn, mapped(candidates(k, view.after, mayBeTorn), weighed));
  }

  std::vector<ScanFit> candidates(std::size_t k, const LocalScan& after, bool mayBeTorn) const {
    std::vector<ScanFit> found = findScan(after, ahead_, result_.poses[k], fitted::kSlipped, 2);
    if (!mayBeTorn) return found;
    for (const ScanFit& fit : findScan(after, ahead_, result_.poses[k - 1], gait_.longest, 4))
      if (gait_.isLikely(result_.poses[k - 1].inverse() * fit.pose, k)) found.push_back(fit);
    return found;
  }

  StepEvidence decide(std::size_t k, const ScanFit& drawn, const std::vector<ScanFit>& found) {
    const bool isImpossible = !isPossible(k) && drawn.quality < fitted::kSlip.mostAsDrawn;
    const auto best = bestOf(found);
    const bool isRefuted =
        drawn.quality < fitted::kTear.mostAsDrawn && drawn.score < -fitted::kTear.leastGain / 2;
    const StepEvidence unmended = isRefuted ? StepEvidence::lost : StepEvidence::none;
    if (best == found.end()) return isImpossible ? mendTo(k, result_.poses[k - 1]) : unmended;
    if (areNear(best->pose, result_.poses[k], {}, kAsDrawn)) return StepEvidence::none;
    const double second = secondOf(found, *best, drawn);
    const bool isSlip =
        areNear(best->pose, result_.poses[k], {}, fitted::kSlipped) &&
        (refutes(fitted::kSlip, drawn, *best) || refutes(fitted::kClearSlip, drawn, *best)) &&
        second - drawn.score < kRivalScore * (best->score - drawn.score);
    // Where a scan shows what none before it has seen, nothing speaks against the step, however
    // well it fits elsewhere: buildings repeat themselves.
    const bool isTear = drawn.known >= fitted::kMaySpeak && refutes(fitted::kTear, drawn, *best);
    if (isTear) return mendTo(k, nearerOne(found, *best, drawn, result_.poses[k]));
    if (isSlip || isImpossible) return mendTo(k, best->pose);
    return unmended;
  }

  StepEvidence mendTo(std::size_t k, const Transform2D& pose) {
    result_.poses[k] = pose;
    isMended_ = true;
    return StepEvidence::contradicts;
  }

  /** One scan and not those behind it: the steps to it and from it are wrong. */
  void mendAlone(std::size_t k, const Transform2D& pose) {
    result_.evidence[k] = result_.evidence[k + 1] = mendTo(k, pose);
    ahead_.walls.clear();  // that scan may be in it
  }

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& drawn_;
  const std::vector<bool>& asked_;
  Gait gait_;
  ScansOfStep sides_;
  MendedSteps result_;
  bool isMended_ = false;
  WallMap ahead_;
  std::size_t aheadOf_ = 0;  // the first scan that is not in that map
};

}  // namespace

MendedSteps mendSteps(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
                      const std::vector<bool>& asked) {
  return Mender(scans, drawn, asked).mended();
}

}  // namespace roomgraph
