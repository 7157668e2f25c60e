#include "find_doubled.h"

#include <algorithm>

#include "fitted_check.h"
#include "roomgraph/align/LocalScan.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/check/ScanPair.h"

namespace roomgraph {
namespace {

/** The run as drawn but for its breaks. */
std::vector<Transform2D> withoutBreaks(const std::vector<Transform2D>& drawn,
                                       const std::vector<Transform2D>& agreed,
                                       const std::vector<std::size_t>& broken) {
  std::vector<Transform2D> poses = drawn;
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const std::vector<Transform2D>& as = contains(broken, k) ? agreed : drawn;
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
        path_(run.scans) {
    for (const PoseEdge& edge : consensus.revisits) {
      ScanPair seen = scanPair(edge.from.index(), edge.to.index());
      if (!isInlier(edge, agreed_))
        refuted_.push_back(seen);
      else if (seen.apart = apart(seen, drawn_); isTold(seen))
        told_.push_back(seen);
    }
  }

  std::vector<DoubledPlace> places() const {
    std::vector<DoubledPlace> places;
    for (const std::vector<ScanPair>& group : path_.grouped(told_))
      if (areMostlyInliers(group)) places.push_back(placeOf(group));
    sortDownBy(places, &DoubledPlace::apart);
    return places;
  }

 private:
  /** Where the later scan has the earlier one, if the key frames lie so. */
  Transform2D poseAgain(const ScanPair& seen, const std::vector<Transform2D>& poses) const {
    return poses[seen.other] * (agreed_[seen.other].inverse() * agreed_[seen.one]);
  }

  double apart(const ScanPair& seen, const std::vector<Transform2D>& poses) const {
    return distance(poses[seen.one].shift(), poseAgain(seen, poses).shift());
  }

  bool isTold(const ScanPair& seen) const {
    return std::min(seen.apart, apart(seen, unbroken_)) >
           std::max(kBreakShift, kMajority * seen.apart);
  }

  /** In a building that repeats itself much is found, and little of it together. */
  bool areMostlyInliers(const std::vector<ScanPair>& group) const {
    const auto misses = countIf(refuted_, [&](const ScanPair& miss) {
      return anyOf(group, [&](const ScanPair& seen) { return path_.areBeside(miss, seen); });
    });
    return group.size() >= fitted::kLeastAcross &&
           group.size() > fitted::kFitsPerMiss * std::size_t(misses);
  }

  DoubledPlace placeOf(const std::vector<ScanPair>& group) const {
    const auto byApart = [](const ScanPair& l, const ScanPair& r) { return l.apart < r.apart; };
    const ScanPair& farthest = *std::max_element(group.begin(), group.end(), byApart);
    const Transform2D again = poseAgain(farthest, drawn_);
    DoubledPlace place{stretchOf(run_, group, &ScanPair::one, farthest.one),
                       stretchOf(run_, group, &ScanPair::other, farthest.other), farthest.apart,
                       drawn_[farthest.one] * again.inverse()};
    place.other.place = again.shift();
    return place;
  }

  const Run& run_;
  const std::vector<Transform2D>& agreed_;
  std::vector<Transform2D> drawn_, unbroken_;
  PathOfRun path_;
  std::vector<ScanPair> told_, refuted_;
};

}  // namespace

std::vector<DoubledPlace> findDoubled(const Run& run, const SelfConsensus& consensus,
                                      const std::vector<std::size_t>& broken) {
  return DoubledPlaces(run, consensus, broken).places();
}

}  // namespace roomgraph
