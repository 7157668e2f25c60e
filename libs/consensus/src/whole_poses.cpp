#include "whole_poses.h"

#include "belief.h"

namespace roomgraph {
namespace {

constexpr int kVotes = 4;

class Voting {
 public:
  Voting(const std::vector<RunSubmaps>& runs, const std::vector<RunMatches>& matches)
      : runs_(runs), matches_(matches), wholes_(runs.size()) {}

  /** All runs placed, beginning with this one: always the run next for which most speaks. */
  double placeFrom(std::size_t first) {
    isPlaced_.assign(runs_.size(), false);
    wholes_.assign(runs_.size(), {});
    isPlaced_[first] = true;
    while (placeNext()) {
    }
    for (int round = 0; round < kVotes; ++round) {
      bool hasMoved = false;
      for (std::size_t r = 0; r < runs_.size(); ++r) hasMoved |= r != first && improve(r);
      if (!hasMoved) break;
    }
    double support = 0;
    for (std::size_t r = 0; r < runs_.size(); ++r) support += supportOf(r, wholes_[r]);
    return support;
  }

  SubmapPoses poses() const {
    SubmapPoses poses(runs_.size());
    for (std::size_t r = 0; r < runs_.size(); ++r)
      for (const Submap& submap : runs_[r].submaps) poses[r].push_back(wholes_[r] * submap.pose);
    return poses;
  }

 private:
  struct Place {
    Transform2D whole;
    double support = 0;
  };

  bool placeNext() {
    std::size_t next = 0;
    Place best;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (isPlaced_[r]) continue;
      if (const Place place = bestPlace(r); place.support > best.support) best = place, next = r;
    }
    if (best.support <= 0) return false;
    wholes_[next] = best.whole;
    return isPlaced_[next] = true;
  }

  bool improve(std::size_t run) {
    if (!isPlaced_[run]) return false;
    const Place best = bestPlace(run);
    if (best.support <= supportOf(run, wholes_[run])) return false;
    wholes_[run] = best.whole;
    return true;
  }

  /** Of the places where a piece would have the run, that which the matches bear out most. */
  Place bestPlace(std::size_t run) const {
    Place best;
    for (const RunMatches& piece : matches_) {
      const bool isOf = piece.of == run;
      if ((!isOf && piece.in != run) || !isPlaced_[isOf ? piece.in : piece.of]) continue;
      const SubmapMatch& match = piece.matches[piece.matches.size() / 2];
      const Transform2D ofInIn = runs_[piece.in].submaps[match.in].pose * match.pose *
                                 runs_[piece.of].submaps[match.submap].pose.inverse();
      const Transform2D whole =
          isOf ? wholes_[piece.in] * ofInIn : wholes_[piece.of] * ofInIn.inverse();
      if (const double support = supportOf(run, whole); support > best.support)
        best = {whole, support};
    }
    return best;
  }

  /** The matches with placed runs that bear out where this run lies. */
  double supportOf(std::size_t run, const Transform2D& whole) const {
    double support = 0;
    for (const RunMatches& piece : matches_) {
      const bool isOf = piece.of == run;
      if ((!isOf && piece.in != run) || !isPlaced_[isOf ? piece.in : piece.of]) continue;
      const Transform2D& in = isOf ? wholes_[piece.in] : whole;
      const Transform2D& of = isOf ? whole : wholes_[piece.of];
      for (const SubmapMatch& match : piece.matches)
        if (isBorneOut(match, in * runs_[piece.in].submaps[match.in].pose,
                       of * runs_[piece.of].submaps[match.submap].pose, kRoughly))
          support += match.weight;
    }
    return support;
  }

  const std::vector<RunSubmaps>& runs_;
  const std::vector<RunMatches>& matches_;
  std::vector<Transform2D> wholes_;  // site <- run
  std::vector<bool> isPlaced_;
};

}  // namespace

SubmapPoses wholePoses(const std::vector<RunSubmaps>& runs, const std::vector<RunMatches>& matches,
                       std::optional<std::size_t> reference) {
  Voting voting(runs, matches);
  voting.placeFrom(reference.value_or(0));
  return voting.poses();
}

}  // namespace roomgraph
