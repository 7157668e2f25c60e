#include "roomgraph/consensus/mend_steps.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "fitted_consensus.h"
#include "gait.h"
#include "roomgraph/base/majority.h"

namespace roomgraph {
namespace {

constexpr std::size_t kScansAhead = 8;    // that draw the map in which the next is looked for
constexpr std::size_t kScansAround = 24;  // the same, where it was not found so
constexpr std::size_t kScansBehind = 6;   // that draw the map in which those ahead are looked for
constexpr std::size_t kTogether = 3;      // scans that are looked for as one, or in one map
constexpr PoseTolerance kAsDrawn{0.05, 0.2};
constexpr PoseTolerance kSlipped{0.35, 0.9};  // what ICP is wrong by where it slips

/** Whether a step by which the scans fit so much better is wrong as it was drawn. */
struct Contradiction {
  double mostAsDrawn, leastElsewhere, leastGain;

  bool holds(const ScanFit& drawn, const ScanFit& found) const {
    return drawn.quality < mostAsDrawn && found.quality > leastElsewhere &&
           found.score - drawn.score > leastGain;
  }
};
constexpr Contradiction kSlip{fitted::kLeastQuality, 0.52, 15}, kClearSlip{0.35, 0.42, 35},
    kTear{0.15, 0.4, 40};
constexpr double kMaySpeak = 0.05;  // share of the walls of a scan that can speak against a step
// Of one scan in what those behind it have drawn, where that shows a slip: how much better it fits
// there than as it was drawn.
constexpr double kClearerBehind = 0.25, kGainBehind = 8;

class Mender {
 public:
  Mender(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
         const std::vector<bool>& asked)
      : scans_(scans), drawn_(drawn), asked_(asked), gait_(drawn, timesOf(scans)) {}

  MendedSteps mended() {
    result_.poses = drawn_;
    result_.evidence.assign(drawn_.size(), StepEvidence::none);
    for (std::size_t k = 1; k < drawn_.size(); ++k) {
      mend(k);
      if (isAsked(k) && result_.evidence[k] != StepEvidence::contradicts) lookBack(k);
    }
    return std::move(result_);
  }

  bool refutes(std::size_t k, const Transform2D& other) {
    result_.poses = drawn_;
    drawAhead(k);
    if (ahead_.walls.empty() || !scans_[k].isTelling()) return false;
    const StepView view = viewOf(k);
    const ScanFit drawn = weighed(k, view, asDrawn(view.after, ahead_, drawn_[k]));
    const ScanFit fit = weighed(k, view, asDrawn(view.after, ahead_, drawn_[k - 1] * other));
    return drawn.quality >= kMajority &&
           (drawn.score - fit.score > kClearSlip.leastGain || !gait_.isLikely(other, k));
  }

 private:
  Transform2D step(std::size_t from, std::size_t to) const {
    return drawn_[from].inverse() * drawn_[to];
  }

  bool isAsked(std::size_t k) const { return asked_.empty() || asked_[k]; }

  /** Of the walls that count [m]. */
  double range() const { return 10 + 2 * gait_.longest.place; }

  bool isPossible(std::size_t k) const { return gait_.isPossible(step(k - 1, k), k); }

  void mend(std::size_t k) {
    // As drawn to the last bit, up to the first contradiction.
    result_.poses[k] = isMended_ ? result_.poses[k - 1] * step(k - 1, k) : drawn_[k];
    if (!isAsked(k) || !scans_[k].isTelling()) return;
    if (ahead_.walls.empty() || k >= aheadOf_ + kTogether) drawAhead(k);
    if (ahead_.walls.empty()) return;
    const ScanFit fit = asDrawn(scans_[k], ahead_, result_.poses[k]);
    if (fit.quality >= fitted::kWell) {
      result_.evidence[k] = StepEvidence::agrees;
      return;
    }
    if (aheadOf_ != k) drawAhead(k);
    result_.evidence[k] = judge(k);
    if (result_.evidence[k] != StepEvidence::lost) return;
    drawAround(k);
    result_.evidence[k] = judge(k);
    ahead_.walls.clear();  // of the steps behind those before it tell more
  }

  void drawAhead(std::size_t k) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = k; i-- > 0 && chosen.size() < kScansAhead;)
      if (scans_[i].isTelling()) chosen.push_back(i);
    draw(chosen, k);
  }

  /** What was drawn about the robot at any time before: it may turn to what only that shows. */
  void drawAround(std::size_t k) {
    const Point robot = result_.poses[k - 1].shift();
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < k; ++i)
      if (scans_[i].isTelling()) near.emplace_back(distance(result_.poses[i].shift(), robot), i);
    const std::size_t count = std::min(near.size(), kScansAround);
    std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(near[i].second);
    draw(chosen, k);
  }

  void draw(const std::vector<std::size_t>& chosen, std::size_t k) {
    ahead_ = scanMap(scans_, result_.poses, chosen, range());
    aheadOf_ = k;
  }

  /** Where it was drawn, up to what scans are off by; as it is where the fit leads elsewhere. */
  static ScanFit asDrawn(const LocalScan& scan, const WallMap& in, const Transform2D& drawn) {
    const ScanFit fit = fitNear(scan, in, drawn);
    return areNear(fit.pose, drawn, {}, kAsDrawn) ? fit : fitAt(scan, in, drawn);
  }

  /** Some scans as one, in the frame of `poses`. */
  LocalScan together(std::size_t first, std::size_t end,
                     const std::vector<Transform2D>& poses) const {
    LocalScan all;
    for (std::size_t i = first; i < end; ++i) {
      const Motion2D forth(poses[i]);
      for (const WallPoint& wall : scans_[i].walls)
        if (norm(wall.place) < range())
          all.walls.push_back({forth(wall.place), forth.turned(wall.normal)});
    }
    return all;
  }

  /** Where the scans lie of which that at `k` is the first, seen from it. */
  std::vector<Transform2D> posesFrom(std::size_t k) const {
    std::vector<Transform2D> fromHere(scans_.size());
    for (std::size_t i = k; i < endBehind(k); ++i) fromHere[i] = step(k, i);
    return fromHere;
  }

  std::size_t endBehind(std::size_t k) const { return std::min(k + kScansBehind, scans_.size()); }

  /** What the scans behind the step to `k` have drawn, seen from the first of them. */
  const WallMap& drawnBehind(std::size_t k) {
    if (behindOf_ == k) return behind_;
    std::vector<std::size_t> chosen(endBehind(k) - k);
    std::iota(chosen.begin(), chosen.end(), k);
    behind_ = scanMap(scans_, posesFrom(k), chosen, range());
    behindOf_ = k;
    return behind_;
  }

  /** Holds the one scan before a step against those behind it. A scan that lies wrong on its own
   *  is not seen by judge(), which takes it together with others that lie right. */
  void lookBack(std::size_t k) {
    const LocalScan& scan = scans_[k - 1];
    if (!scan.isTelling()) return;
    const WallMap& behind = drawnBehind(k);
    if (behind.walls.empty()) return;
    const Transform2D back = result_.poses[k].inverse() * result_.poses[k - 1];
    const ScanFit drawn = asDrawn(scan, behind, back);
    if (drawn.known < kMaySpeak || drawn.quality + kClearerBehind > 1) return;
    const std::vector<ScanFit> found = findScan(scan, behind, back, kSlipped, 2);
    const auto best = bestOf(found);
    if (best == found.end() || areNear(best->pose, back, {}, kAsDrawn)) return;
    const bool mayBe = areNear(best->pose, back, {}, kSlipped) || drawn.quality < kTear.mostAsDrawn;
    const double gain = best->score - drawn.score;
    if (!mayBe || best->quality < kMajority || best->quality < drawn.quality + kClearerBehind ||
        gain < kGainBehind || secondOf(found, *best, drawn) - drawn.score > kRivalScore * gain)
      return;
    mendBack(k, behind, best->pose);
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
        mendTo(k - 1, mended);
        result_.evidence[k - 1] = result_.evidence[k] = StepEvidence::contradicts;
        ahead_.walls.clear();  // that scan may be in it
        return;
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

  /** The scans on both sides of a step. */
  struct StepView {
    LocalScan before, after;
  };

  StepView viewOf(std::size_t k) const {
    return {together(k - std::min(k, kTogether), k, result_.poses),
            together(k, std::min(k + kTogether, scans_.size()), posesFrom(k))};
  }

  /** A fit by the walls of both sides. */
  ScanFit weighed(std::size_t k, const StepView& view, ScanFit fit) {
    const ScanFit back = fitAt(view.before, drawnBehind(k), fit.pose.inverse());
    const double known = std::max(1e-9, fit.known + back.known);
    fit.quality = (fit.quality * fit.known + back.quality * back.known) / known;
    fit.score += back.score;
    fit.known = known / 2;
    return fit;
  }

  StepEvidence judge(std::size_t k) {
    const StepView view = viewOf(k);
    const ScanFit drawn = weighed(k, view, asDrawn(view.after, ahead_, result_.poses[k]));
    if (isPossible(k) && drawn.quality >= kSlip.mostAsDrawn)
      return drawn.quality >= kMajority ? StepEvidence::agrees : StepEvidence::none;
    const bool mayBeTorn = !isPossible(k) || drawn.quality < kTear.mostAsDrawn;
    std::vector<ScanFit> found;
    for (const ScanFit& fit : candidates(k, view.after, mayBeTorn))
      found.push_back(weighed(k, view, fit));
    return decide(k, drawn, found);
  }

  std::vector<ScanFit> candidates(std::size_t k, const LocalScan& after, bool mayBeTorn) const {
    std::vector<ScanFit> found = findScan(after, ahead_, result_.poses[k], kSlipped, 2);
    if (!mayBeTorn) return found;
    for (const ScanFit& fit : findScan(after, ahead_, result_.poses[k - 1], gait_.longest, 4))
      if (gait_.isLikely(result_.poses[k - 1].inverse() * fit.pose, k)) found.push_back(fit);
    return found;
  }

  StepEvidence decide(std::size_t k, const ScanFit& drawn, const std::vector<ScanFit>& found) {
    const bool isImpossible = !isPossible(k) && drawn.quality < kSlip.mostAsDrawn;
    const auto best = bestOf(found);
    const bool isRefuted = drawn.quality < kTear.mostAsDrawn && drawn.score < -kTear.leastGain / 2;
    const StepEvidence unmended = isRefuted ? StepEvidence::lost : StepEvidence::none;
    if (best == found.end()) return isImpossible ? mendTo(k, result_.poses[k - 1]) : unmended;
    if (areNear(best->pose, result_.poses[k], {}, kAsDrawn)) return StepEvidence::none;
    const double second = secondOf(found, *best, drawn);
    const bool isSlip = areNear(best->pose, result_.poses[k], {}, kSlipped) &&
                        (kSlip.holds(drawn, *best) || kClearSlip.holds(drawn, *best)) &&
                        second - drawn.score < kRivalScore * (best->score - drawn.score);
    // Where a scan shows what none before it has seen, nothing speaks against the step, however
    // well it fits elsewhere: buildings repeat themselves.
    const bool isTear = drawn.known >= kMaySpeak && kTear.holds(drawn, *best);
    if (isSlip || isImpossible || isTear) return mendTo(k, best->pose);
    return unmended;
  }

  StepEvidence mendTo(std::size_t k, const Transform2D& pose) {
    result_.poses[k] = pose;
    isMended_ = true;
    return StepEvidence::contradicts;
  }

  const std::vector<LocalScan>& scans_;
  const std::vector<Transform2D>& drawn_;
  const std::vector<bool>& asked_;
  Gait gait_;
  MendedSteps result_;
  bool isMended_ = false;
  WallMap ahead_;
  std::size_t aheadOf_ = 0;  // the first scan that is not in that map
  WallMap behind_;
  std::size_t behindOf_ = 0;  // the first scan in that map; 0 before there is one
};

}  // namespace

MendedSteps mendSteps(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
                      const std::vector<bool>& asked) {
  return Mender(scans, drawn, asked).mended();
}

bool isRefuted(const std::vector<LocalScan>& scans, const std::vector<Transform2D>& drawn,
               std::size_t k, const Transform2D& step) {
  return Mender(scans, drawn, {}).refutes(k, step);
}

}  // namespace roomgraph
