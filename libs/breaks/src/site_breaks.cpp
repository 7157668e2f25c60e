#include "roomgraph/breaks/site_breaks.h"

#include <cmath>

#include "fitted_breaks.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/breaks/find_breaks.h"
#include "roomgraph/breaks/find_pieces.h"
#include "roomgraph/consensus/StepWitness.h"

namespace roomgraph {
namespace {

/** Looks for the breaks of one run. */
class BreakSearch {
 public:
  BreakSearch(const Site& site, const MapPairs& pairs, const Consensus& consensus,
              const Trust& trust, const FindBreaksOptions& options, std::size_t run)
      : site_(site), pairs_(pairs), consensus_(consensus), options_(options), run_(run) {
    witnesses_ = witnesses(trust);
    // Trust is steep: its root lets two good maps outvote a better one.
    for (const std::size_t j : witnesses_) votes_.push_back(std::sqrt(trust[j]));
    ownVote_ = std::sqrt(trust[run]);
  }

  std::vector<MapBreak> breaks() const {
    return site_.runs[run_]->scans.empty() ? seam() : jumps();
  }

 private:
  /** The runs that tell best where this one breaks: those that are trusted most. */
  std::vector<std::size_t> witnesses(const Trust& trust) const {
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < site_.runs.size(); ++j)
      if (j != run_ && followedIn(pairs_, run_, j).share >= kWitnessShare) others.push_back(j);
    sortDownBy(others, [&](std::size_t j) { return trust[j]; });
    if (others.size() > fitted::kWitnesses) others.resize(fitted::kWitnesses);
    return others;
  }

  /** Of a run with scans: where the consensus has torn it. */
  std::vector<MapBreak> jumps() const {
    if (consensus_.errorOf(run_).seen <= 0) return {};  // its own scans alone do not tell
    const Run& run = *site_.runs[run_];
    ScanTrack track;  // where each scan lies in the consensus
    for (std::size_t k = 0; k < run.scans.size(); ++k)
      track.push_back(poseOf(k) * run.scans[k].pose.inverse());
    const std::vector<ScanBreak> found = findBreaks(run.scans, track, options_);
    if (found.empty()) return {};
    const std::vector<LocalScan> scans = localScans(run.scans);
    const std::vector<Transform2D> drawn = drawnPoses(run.scans);
    StepWitness witness(scans, drawn);
    std::vector<MapBreak> breaks;
    for (const ScanBreak& one : found) {
      MapBreak tear = breakOf(one);
      if (isLikely(one, tear.kind(), witness)) breaks.push_back(std::move(tear));
    }
    return breaks;
  }

  /** False where the scans on both sides of a step hold it as it was drawn: where a run bends
   *  little by little, the consensus lets single steps give way. Slight breaks come and go there:
   *  true of those only with which these scans fit better. */
  bool isLikely(const ScanBreak& found, BreakClass kind, StepWitness& witness) const {
    const std::size_t k = found.behind;
    if (k != found.before + 1) return true;
    const Transform2D step = poseOf(k - 1).inverse() * poseOf(k);
    return kind == BreakClass::slight ? witness.prefers(k, step) : !witness.refutes(k, step);
  }

  /** Where a scan lies in the consensus. */
  const Transform2D& poseOf(std::size_t scan) const {
    return consensus_.poses[consensus_.nodesOf(run_)[scan]];
  }

  MapBreak breakOf(const ScanBreak& found) const {
    const Run& run = *site_.runs[run_];
    // What would mend the run: untorn <- run, for all from the break on.
    const Transform2D mend = run.scans[found.before].pose * poseOf(found.before).inverse() *
                             poseOf(found.behind) * run.scans[found.behind].pose.inverse();
    const ScanWalls& scan = run.scans[found.scan];
    const Transform2D& pose = site_.poses[run_];
    const TornPose torn{pose * scan.pose, pose * mend * scan.pose};
    return {run.name, torn.untorn.shift(), found.rotation, found.shift, scan.keyFrame, scan.time,
            torn};
  }

  /** Of a run without scans: whether it lies in the others as two pieces. The word of that witness
   *  counts in which they bend least. */
  std::vector<MapBreak> seam() const {
    const std::vector<std::optional<PieceBreak>> found = toldByWitnesses();
    const PieceBreak* best = nullptr;
    double bestWeight = 0;
    for (const auto& told : found) {
      if (!told) continue;
      const double weight = votesFor(*told, found);
      if (best && (weight < bestWeight || (weight == bestWeight && told->bend >= best->bend)))
        continue;
      best = &*told, bestWeight = weight;
    }
    if (!best || bestWeight <= kMajority * votesOn(*best, found)) return {};
    return {{site_.runs[run_]->name, site_.poses[run_](best->place), best->rotation, best->shift,
             std::nullopt, std::nullopt}};
  }

  std::vector<std::optional<PieceBreak>> toldByWitnesses() const {
    return mapped(witnesses_, [&](std::size_t j) {
      return findPieces(site_.runs[run_]->map.patches, followedIn(pairs_, run_, j), options_);
    });
  }

  /** The votes of the witnesses that tell of the same break. */
  double votesFor(const PieceBreak& one,
                  const std::vector<std::optional<PieceBreak>>& found) const {
    double sum = 0;
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k] && areSame(one, *found[k])) sum += votes_[k];
    return sum;
  }

  /** The votes of all but those that know only one of the pieces; its own is that it has none, so
   *  that worse maps do not lay their breaks on a better one. */
  double votesOn(const PieceBreak& one, const std::vector<std::optional<PieceBreak>>& found) const {
    double sum = ownVote_;
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k] || knows(witnesses_[k], one)) sum += votes_[k];
    return sum;
  }

  bool knows(std::size_t witness, const PieceBreak& found) const {
    std::vector<bool> isKnown(site_.runs[run_]->map.patches.size());
    for (const FollowedPatch& f : followedIn(pairs_, run_, witness).patches)
      isKnown[f.patch] = true;
    return allOf(found.pieces, [&](const auto& piece) {
      const auto known = countIf(piece, [&](std::size_t k) { return isKnown[k]; });
      return 2 * known >= piece.size();
    });
  }

  /** Which of two pieces is the smaller one can differ from map to map. */
  static bool areSame(const PieceBreak& l, const PieceBreak& r) {
    return std::abs(std::abs(l.rotation) - std::abs(r.rotation)) <= kSameAnswer.turn &&
           std::abs(l.shift - r.shift) <= kSameAnswer.place;
  }

  const Site& site_;
  const MapPairs& pairs_;
  const Consensus& consensus_;
  const FindBreaksOptions& options_;
  std::size_t run_;
  std::vector<std::size_t> witnesses_;
  std::vector<double> votes_;  // of each witness
  double ownVote_ = 0;
};

}  // namespace

std::vector<std::vector<MapBreak>> siteBreaks(const Site& site, const MapPairs& pairs,
                                              const Consensus& consensus, const Trust& trust,
                                              const FindBreaksOptions& options,
                                              const ForEach& forEach) {
  std::vector<std::vector<MapBreak>> breaks(site.runs.size());
  forEach(breaks.size(), [&](std::size_t i) {
    breaks[i] = BreakSearch(site, pairs, consensus, trust, options, i).breaks();
  });
  return breaks;
}

}  // namespace roomgraph
