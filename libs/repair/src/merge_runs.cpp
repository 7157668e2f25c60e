#include "roomgraph/repair/merge_runs.h"

#include <algorithm>
#include <cmath>

#include "fitted_repair.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/base/time_text.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/repair/CellVotes.h"

namespace roomgraph {
namespace {

using LeftOut = std::vector<std::vector<std::size_t>>;

class Merger {
 public:
  Merger(const std::vector<MergedRun>& runs, const MergeOptions& options)
      : runs_(runs), options_(options), order_(numbersFrom(0, runs.size())) {
    sortBy(order_, [&](std::size_t r) { return runs_[r].time.value_or(0); });
    for (const MergedRun& run : runs)
      if (!run.drawn.empty() && run.drawn.size() != run.scans.size())
        throw UsageError("merge_runs: " + run.name + " has other scans than it has drawn");
    const bool areTimed = allOf(runs, [](const MergedRun& run) { return run.time.has_value(); });
    const auto timeOf = [&](std::size_t back) { return runs_[order_[runs.size() - back]].time; };
    knowsLatest_ = areTimed && (runs.size() < 3 || timeOf(3) < timeOf(2));
    setFrame();
  }

  MergedMap merge(const ForEach& forEach) {
    std::vector<CellVotes> votes(runs_.size(), CellVotes(frame_));
    forEach(runs_.size(), [&](std::size_t r) { votes[r] = votesOf(r, {}); });
    LeftOut leftOut(runs_.size());
    forEach(runs_.size(), [&](std::size_t r) { leftOut[r] = contradicted(r, votes); });
    forEach(runs_.size(), [&](std::size_t r) {
      if (!leftOut[r].empty()) votes[r] = votesOf(r, leftOut[r]);
    });
    MergedMap merged = drawn(votes);
    merged.leftOut = std::move(leftOut);
    return merged;
  }

 private:
  /** What other runs say of a beam. */
  enum class Word { none, with, against };

  void setFrame() {
    Box box;
    for (const MergedRun& run : runs_)
      for (const Keyframe& scan : run.scans) {
        box.include(scan.pose.shift());
        for (const Point end : scan.ends) box.include(scan.pose(end));
      }
    const double side = options_.resolution;
    const double width = box.size().x / side + 4, height = box.size().y / side + 4;
    if (!(width * height < double(kMostCells)))
      throw DataError(
          "merge: the runs reach over more than 400 million cells: use a coarser resolution, or "
          "leave out what is far off");
    frame_.resolution = side;
    frame_.origin = {side * (std::floor(box.low.x / side) - 1),
                     side * (std::floor(box.low.y / side) - 1)};
    frame_.width = int(width), frame_.height = int(height);
  }

  CellVotes votesOf(std::size_t r, const std::vector<std::size_t>& without) const {
    CellVotes votes(frame_);
    const std::vector<Keyframe>& scans = runs_[r].scans;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      if (std::binary_search(without.begin(), without.end(), k)) continue;
      for (const Point end : scans[k].ends)
        votes.addBeam(scans[k].pose.shift(), scans[k].pose(end));
    }
    return votes;
  }

  /** Of the two runs made last the other one, which alone knows what has been moved; of others
   *  none. */
  std::optional<std::size_t> mateOf(std::size_t r) const {
    if (!knowsLatest_ || runs_.size() < 3) return std::nullopt;
    const std::size_t last = order_.back(), before = order_[order_.size() - 2];
    if (r != last && r != before) return std::nullopt;
    return r == last ? before : last;
  }

  /** What the runs that have seen a cell well, but this one, say of a beam that ends there: it is
   *  contradicted if most look through all around it, and its mate, if it has seen it well, too. */
  Word othersOn(std::size_t r, Cell cell, const std::vector<CellVotes>& votes) const {
    const auto mate = mateOf(r);
    std::size_t free = 0, known = 0;
    for (std::size_t other = 0; other < votes.size(); ++other) {
      if (other == r || votes[other].seen(frame_.index(cell)) < fitted::kSureBeams) continue;
      double most = 0;
      for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
          if (const Cell near{cell.x + x, cell.y + y}; frame_.contains(near))
            most = std::max(most, votes[other].wallShare(frame_.index(near)));
      const bool isFree = most <= fitted::kClearlyFree;
      if (other == mate && !isFree) return Word::with;
      ++known, free += isFree;
    }
    if (known == 0) return Word::none;
    return 2 * free > known ? Word::against : Word::with;
  }

  /** Whether a cell is wall to most runs that have seen it well, but this one, and its mate, if
   *  it has, does not look through. */
  bool isWallForOthers(std::size_t r, std::size_t cell, const std::vector<CellVotes>& votes) const {
    const auto mate = mateOf(r);
    std::size_t walls = 0, known = 0;
    for (std::size_t other = 0; other < votes.size(); ++other) {
      if (other == r || votes[other].seen(cell) < fitted::kSureBeams) continue;
      if (other == mate && votes[other].wallShare(cell) <= fitted::kClearlyFree) return false;
      ++known, walls += votes[other].wallShare(cell) >= kMajority;
    }
    return 2 * walls > known;
  }

  /** Whether a beam has gone through a wall of others: it goes on well behind it. */
  bool goesThrough(std::size_t r, Point eye, Point end, const std::vector<CellVotes>& votes) const {
    const double length = distance(eye, end);
    if (length <= fitted::kBehindWall) return false;
    bool isThrough = false;
    passBeam(frame_, eye, eye + (1 - fitted::kBehindWall / length) * (end - eye),
             [&](std::size_t cell) { isThrough = isThrough || isWallForOthers(r, cell, votes); });
    return isThrough;
  }

  /** How many beams of a scan others bear out, and contradict. */
  struct Told {
    std::size_t with = 0, against = 0, beams = 0;

    std::size_t all() const { return with + against; }
    bool isMuch(std::size_t told) const { return double(told) > fitted::kToldOf * double(beams); }
    double shareAgainst() const {
      return double(against) / double(std::max<std::size_t>(1, all()));
    }
  };

  Told toldOf(std::size_t r, const Keyframe& scan, const std::vector<CellVotes>& votes) const {
    Told told{0, 0, scan.ends.size()};
    for (const Point inScan : scan.ends) {
      const Point end = scan.pose(inScan);
      const Word word = goesThrough(r, scan.pose.shift(), end, votes)
                            ? Word::against
                            : othersOn(r, frame_.cellAt(end), votes);
      told.with += word == Word::with, told.against += word == Word::against;
    }
    return told;
  }

  /** The share of its beams that others may contradict of a scan in its right place: twice as much
   *  as usual in its run, since much may have been moved, but never more than half. */
  static double mostAgainst(const std::vector<Told>& run) {
    std::vector<double> shares;
    for (const Told& told : run)
      if (told.isMuch(told.all())) shares.push_back(told.shareAgainst());
    if (shares.empty()) return fitted::kMostAgainst;
    return std::clamp(2 * median(shares), fitted::kMostAgainst, kMajority);
  }

  /** What the others say of a scan; none where they tell of few beams. */
  static Word wordOn(const Told& told, double most) {
    if (told.shareAgainst() > most) return told.isMuch(told.against) ? Word::against : Word::none;
    return told.isMuch(told.all()) ? Word::with : Word::none;
  }

  /** The scans of a run that others contradict, and those of which they tell nothing between them,
   *  or between one and an end of the run. */
  std::vector<std::size_t> contradicted(std::size_t r, const std::vector<CellVotes>& votes) const {
    const std::size_t count = runs_[r].scans.size();
    std::vector<Word> before(count + 1, Word::none), behind = before;
    const auto told =
        mapped(runs_[r].scans, [&](const Keyframe& scan) { return toldOf(r, scan, votes); });
    const auto words =
        mapped(told, [most = mostAgainst(told)](const Told& one) { return wordOn(one, most); });
    const auto toldOr = [](Word word, Word next) { return word == Word::none ? next : word; };
    for (std::size_t k = 0; k < count; ++k) before[k + 1] = toldOr(words[k], before[k]);
    for (std::size_t k = count; k-- > 0;) behind[k] = toldOr(words[k], behind[k + 1]);
    std::vector<bool> isOut(count);
    for (std::size_t k = 0; k < count; ++k)
      isOut[k] = (before[k + 1] == Word::against || behind[k] == Word::against) &&
                 before[k + 1] != Word::with && behind[k] != Word::with;
    leaveOutPieces(runs_[r], isOut);
    std::vector<std::size_t> scans;
    for (std::size_t k = 0; k < count; ++k)
      if (isOut[k]) scans.push_back(k);
    return scans;
  }

  /** A piece of a run lies where it does as a whole: if most of its scans are left out, all are. */
  static void leaveOutPieces(const MergedRun& run, std::vector<bool>& isOut) {
    for (std::size_t from = 0, k = 1; k <= isOut.size(); ++k) {
      if (k < isOut.size() && !isTorn(run, k)) continue;
      const auto first = isOut.begin() + std::ptrdiff_t(from),
                 end = isOut.begin() + std::ptrdiff_t(k);
      if (2 * std::count(first, end, true) > end - first) std::fill(first, end, true);
      from = k;
    }
  }

  /** Whether a scan lies clearly off from where the run has it behind the one before. */
  static bool isTorn(const MergedRun& run, std::size_t k) {
    if (run.drawn.empty()) return false;
    const Transform2D step = run.scans[k - 1].pose.inverse() * run.scans[k].pose;
    return !areNear(step, run.drawn[k - 1].inverse() * run.drawn[k], {},
                    {kClearRotation, kBreakShift});
  }

  /** Share of the votes for wall, in the order of time; none where nobody has seen it. */
  std::optional<double> shareAt(std::size_t cell, const std::vector<CellVotes>& votes) const {
    double wall = 0, all = 0, weight = 1;
    int agreeing = 0, asked = 0;
    for (const std::size_t r : order_) {
      if (options_.prefersLatest) weight *= 2;
      const std::uint32_t seen = votes[r].seen(cell);
      const double sure = weight * double(seen) / double(seen + 1);
      wall += sure * votes[r].wallShare(cell), all += sure;
    }
    for (auto r = order_.rbegin(); knowsLatest_ && r != order_.rend() && asked < 2; ++r) {
      if (votes[*r].seen(cell) < fitted::kSureBeams) continue;
      ++asked, agreeing += votes[*r].wallShare(cell) <= fitted::kClearlyFree
                               ? -1
                               : votes[*r].wallShare(cell) >= kMajority;
    }
    if (all <= 0) return std::nullopt;
    if (agreeing == 2) return std::max(wall / all, kMajority);
    if (agreeing == -2) return std::min(wall / all, fitted::kClearlyFree);
    return wall / all;
  }

  MergedMap drawn(const std::vector<CellVotes>& votes) const {
    MergedMap merged;
    merged.map.frame = frame_;
    merged.map.grey.assign(frame_.cellCount(), 127);
    merged.map.occupiedAbove = 0.55, merged.map.freeBelow = 0.45;
    merged.runs.assign(frame_.cellCount(), 0);
    merged.time.assign(frame_.cellCount(), -1);
    for (std::size_t cell = 0; cell < frame_.cellCount(); ++cell) {
      const auto share = shareAt(cell, votes);
      if (!share) continue;
      merged.map.grey[cell] = *share >= fitted::kWallShare ? 0 : 255;
      std::size_t seen = 0;
      for (const std::size_t r : order_) {
        if (votes[r].seen(cell) == 0) continue;
        ++seen;
        if (runs_[r].time)
          merged.time[cell] = float((*runs_[order_.back()].time - *runs_[r].time) / kDay);
      }
      merged.runs[cell] = std::uint8_t(std::min<std::size_t>(seen, 255));
    }
    return merged;
  }

  const std::vector<MergedRun>& runs_;
  const MergeOptions& options_;
  std::vector<std::size_t> order_;  // the run made last at its end
  bool knowsLatest_ = false;        // which two were made last
  GridFrame frame_;
};

}  // namespace

MergedMap mergeRuns(const std::vector<MergedRun>& runs, const MergeOptions& options,
                    const ForEach& forEach) {
  return Merger(runs, options).merge(forEach);
}

}  // namespace roomgraph
