#include "find_doubled.h"

#include <algorithm>
#include <utility>

#include "Passes.h"
#include "is_confirmed.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/majority.h"

namespace roomgraph {
namespace {

/** A place that two scans have seen, by their numbers. */
struct SeenAgain {
  std::size_t one = 0, other = 0;  ///< in their order
  double apart = 0;                ///< how far they lie apart as drawn [m]; 0 where that is wrong

  explicit SeenAgain(const PoseEdge& edge)
      : one(std::min(edge.from.index(), edge.to.index())),
        other(std::max(edge.from.index(), edge.to.index())) {}
};

/** The run as drawn but for its breaks. */
std::vector<Transform2D> withoutBreaks(const std::vector<Transform2D>& drawn,
                                       const std::vector<Transform2D>& agreed,
                                       const std::vector<std::size_t>& broken) {
  std::vector<Transform2D> poses = drawn;
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const bool isBroken = std::find(broken.begin(), broken.end(), k) != broken.end();
    const std::vector<Transform2D>& as = isBroken ? agreed : drawn;
    poses[k] = poses[k - 1] * (as[k - 1].inverse() * as[k]);
  }
  return poses;
}

class DoubledPlaces {
 public:
  DoubledPlaces(const Run& run, const SelfConsensus& consensus,
                const std::vector<std::size_t>& broken)
      : run_(run),
        agreed_(consensus.poses),
        drawn_(drawnPoses(run.scans)),
        unbroken_(withoutBreaks(drawn_, agreed_, broken)),
        path_(drawn_.size()) {
    for (std::size_t k = 1; k < drawn_.size(); ++k)
      path_[k] = path_[k - 1] + distance(drawn_[k - 1].shift(), drawn_[k].shift());
    for (const PoseEdge& edge : consensus.revisits) {
      SeenAgain seen(edge);
      if (!isBorneOut(edge, agreed_))
        refuted_.push_back(seen);
      else if (seen.apart = apart(seen, drawn_); isTold(seen))
        told_.push_back(seen);
    }
  }

  std::vector<DoubledPlace> places() const {
    std::vector<DoubledPlace> places;
    for (const std::vector<SeenAgain>& group : groups())
      if (isBorneOutAsAWhole(group)) places.push_back(placeOf(group));
    std::stable_sort(
        places.begin(), places.end(),
        [](const DoubledPlace& l, const DoubledPlace& r) { return l.apart > r.apart; });
    return places;
  }

 private:
  /** Where the later scan has the earlier one, if the key frames lie so. */
  Transform2D poseAgain(const SeenAgain& seen, const std::vector<Transform2D>& poses) const {
    return poses[seen.other] * (agreed_[seen.other].inverse() * agreed_[seen.one]);
  }

  double apart(const SeenAgain& seen, const std::vector<Transform2D>& poses) const {
    return distance(poses[seen.one].shift(), poseAgain(seen, poses).shift());
  }

  bool isTold(const SeenAgain& seen) const {
    return std::min(seen.apart, apart(seen, unbroken_)) >
           std::max(kTellsShift, kMajority * seen.apart);
  }

  bool areBeside(std::size_t l, std::size_t r) const {
    return path_[std::max(l, r)] - path_[std::min(l, r)] < Passes::kLength;
  }

  std::vector<std::vector<SeenAgain>> groups() const {
    UnionFind joined(told_.size());
    for (std::size_t i = 0; i < told_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (areBeside(told_[i].one, told_[j].one) && areBeside(told_[i].other, told_[j].other))
          joined.join(i, j);
    std::vector<std::vector<SeenAgain>> groups(told_.size());
    for (std::size_t i = 0; i < told_.size(); ++i) groups[joined.find(i)].push_back(told_[i]);
    return groups;
  }

  /** In a building that repeats itself much is found, and little of it together. */
  bool isBorneOutAsAWhole(const std::vector<SeenAgain>& group) const {
    const auto misses = std::count_if(refuted_.begin(), refuted_.end(), [&](const SeenAgain& miss) {
      return std::any_of(group.begin(), group.end(), [&](const SeenAgain& seen) {
        return areBeside(miss.one, seen.one) && areBeside(miss.other, seen.other);
      });
    });
    return group.size() >= kLeastAcross && group.size() > kFitsPerMiss * std::size_t(misses);
  }

  DoubledPlace placeOf(const std::vector<SeenAgain>& group) const {
    const auto byApart = [](const SeenAgain& l, const SeenAgain& r) { return l.apart < r.apart; };
    const SeenAgain& farthest = *std::max_element(group.begin(), group.end(), byApart);
    const Transform2D again = poseAgain(farthest, drawn_);
    DoubledPlace place{stretchAt(farthest.one, drawn_[farthest.one].shift()),
                       stretchAt(farthest.other, again.shift()), farthest.apart,
                       drawn_[farthest.one] * again.inverse()};
    for (const SeenAgain& seen : group) widen(place.one, seen.one), widen(place.other, seen.other);
    return place;
  }

  DrawnStretch stretchAt(std::size_t scan, Point place) const {
    const ScanWalls& at = run_.scans[scan];
    return {at.keyFrame, at.keyFrame, at.keyFrame, at.time, place};
  }

  void widen(DrawnStretch& stretch, std::size_t scan) const {
    stretch.first = std::min(stretch.first, run_.scans[scan].keyFrame);
    stretch.last = std::max(stretch.last, run_.scans[scan].keyFrame);
  }

  const Run& run_;
  const std::vector<Transform2D>& agreed_;
  std::vector<Transform2D> drawn_, unbroken_;
  std::vector<double> path_;  // to each scan [m]
  std::vector<SeenAgain> told_, refuted_;
};

}  // namespace

std::vector<DoubledPlace> findDoubled(const Run& run, const SelfConsensus& consensus,
                                      const std::vector<std::size_t>& broken) {
  return DoubledPlaces(run, consensus, broken).places();
}

}  // namespace roomgraph
