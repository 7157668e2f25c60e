#include "roomgraph/relate/follow_walls.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "fitted_relate.h"
#include "roomgraph/align/NarrowingBand.h"
#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/wall_share.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/MotionFit.h"
#include "torn_end.h"

namespace roomgraph {
namespace {

/** Around a wall, of what counts in the fit of a patch. */
constexpr NarrowingBand kPatchBand{0.8, 0.25, 4};

/** A patch as it may be found. */
struct Offer {
  double quality = 0;
  std::uint32_t patch = 0;
  Transform2D pose;

  bool operator<(const Offer& other) const {  // the surest comes first
    return quality != other.quality ? quality < other.quality : patch > other.patch;
  }
};

/** See FollowedWalls::misfit. */
double misfitAt(const WallMap& map, const WallMap& other, const Transform2D& pose) {
  const Motion2D forth(pose);
  double squares = 0, known = 0;
  for (const WallPoint& wall : map.walls) {
    const WallLookUp there = lookUp(wall, other, forth);
    if (!there.isKnown) continue;
    squares += there.wall ? std::min(1.0, squaredNorm(there.wall->place - there.place)) : 1;
    ++known;
  }
  return known > 0 ? std::sqrt(squares / known) : 0;
}

class Follower {
 public:
  Follower(const WallMap& map, const WallMap& other)
      : map_(map),
        other_(other),
        patches_(map.patches),
        foundIn_(map.walls.size(), kNone),
        explainedIn_(other.walls.size(), kNone) {
    for (const WallPatch& patch : patches_) left_.push_back(patch.around);
  }

  FollowedWalls follow(const std::vector<Transform2D>& poses) {
    if (poses.empty() || map_.walls.empty()) return {};
    followFirst(poses.front());
    std::vector<Transform2D> others(poses.begin() + 1, poses.end());
    if (others.size() > fitted::kMaxCandidates) others.resize(fitted::kMaxCandidates);
    for (int piece = 1; piece < fitted::kMaxPieces; ++piece)
      if (!followPiece(poses.front(), others)) break;
    for (int round = 0; round < fitted::kTwinRounds; ++round) followTwins();
    fit();
    if (!(map_.hasScans && other_.hasScans) && followTornEnd()) fit();
    return std::move(result_);
  }

 private:
  /** Moves the pose so that what is left around the patch comes to lie on walls. */
  Transform2D refined(std::uint32_t patch, const Transform2D& pose) const {
    return fittedPose(pose, patches_[patch].middle, kPatchBand, [&](WallFit& fit, int) {
      for (const std::uint32_t k : left_[patch]) fit.add(map_.walls[k], other_);
    });
  }

  /** The share of what is left around the patch that lies on walls, 0 to 1. */
  double qualityAt(std::uint32_t patch, const Transform2D& pose, std::size_t stride = 1) const {
    const std::vector<std::uint32_t>& left = left_[patch];
    const auto pointAt = [&](std::size_t i) -> const WallPoint& { return map_.walls[left[i]]; };
    const WallShare share = wallShare(left.size(), pointAt, other_, pose, kWallNoise, stride);
    const bool isEnough = share.known * double(stride) >= double(kFewestPoints) &&
                          share.known > fitted::kMinKnown * share.all;
    return isEnough ? share.ofKnown(kDoubt / double(stride)) : 0;
  }

  /** Queues the patch where it can be found near `pose`; with `isStep` only close to it. */
  void offer(std::uint32_t patch, const Transform2D& pose, double minQuality, bool isStep) {
    if (left_[patch].size() < kFewestPoints || queued_[patch] >= kSureQuality) return;
    const Transform2D found = refined(patch, pose);
    if (isStep && !areNear(found, pose, patches_[patch].middle, kNextPatch)) return;
    const double quality = qualityAt(patch, found);
    if (quality < minQuality || quality <= queued_[patch]) return;
    queued_[patch] = quality;
    queue_.push({quality, patch, found});
  }

  void offerAround(std::uint32_t patch, const Transform2D& pose, double minQuality) {
    for (const std::uint32_t next : patches_[patch].neighbours)
      if (!isDone_[next]) offer(next, pose, minQuality, true);
  }

  /** Takes what is queued, surest first, and goes on from there. Returns the walls found. */
  double grow(double minQuality) {
    double sum = 0;
    while (!queue_.empty()) {
      const Offer next = queue_.top();
      queue_.pop();
      if (isDone_[next.patch]) continue;
      isDone_[next.patch] = true;
      sum += take(next);
      offerAround(next.patch, next.pose, minQuality);
    }
    return sum;
  }

  double take(const Offer& offer) {
    const Motion2D forth(offer.pose);
    double count = 0;
    for (const std::uint32_t k : patches_[offer.patch].own) {
      if (foundIn_[k] != kNone) continue;
      const Point place = forth(map_.walls[k].place);
      const WallPoint* wall = nearestWall(other_, place, forth.turned(map_.walls[k].normal));
      if (!wall || distance(wall->place, place) > kSameWall) continue;
      foundIn_[k] = layer_;
      int& explained = explainedIn_[std::size_t(wall - other_.walls.data())];
      if (explained == kNone) explained = layer_;
      twice_ += explained != layer_;
      ++count;
    }
    if (count > 0) result_.patches.push_back({offer.patch, offer.pose, count, layer_});
    return count;
  }

  /** Leaves out what has been found, and starts anew. */
  void nextLayer() {
    for (std::vector<std::uint32_t>& points : left_)
      eraseIf(points, [&](std::uint32_t k) { return foundIn_[k] != kNone; });
    isDone_.assign(patches_.size(), false);
    queued_.assign(patches_.size(), 0);
    queue_ = {};
  }

  void followFirst(const Transform2D& pose) {
    nextLayer();
    std::vector<std::pair<double, std::uint32_t>> seeds;
    for (std::uint32_t i = 0; i < patches_.size(); ++i) seeds.push_back({-qualityAt(i, pose), i});
    std::sort(seeds.begin(), seeds.end());
    for (const auto& [quality, patch] : seeds) {
      if (isDone_[patch]) continue;
      offer(patch, pose, kMajority, false);
      grow(kMajority);
    }
  }

  /** How much of what is left lies on walls at `pose`, in wall points, and where it fits best. */
  std::pair<double, std::uint32_t> fitOf(const Transform2D& pose, const Transform2D& first) const {
    double sum = 0, best = 0;
    std::uint32_t seed = 0;
    for (std::uint32_t i = 0; i < patches_.size(); ++i) {
      const WallPatch& patch = patches_[i];
      if (left_[i].size() < kFewestPoints) continue;
      if (distance(pose(patch.middle), first(patch.middle)) > kMaxBend) continue;
      const double quality = qualityAt(i, pose, kQuickStride);
      if (quality >= kFairQuality)
        sum += quality * double(patch.own.size() * left_[i].size()) / double(patch.around.size());
      if (quality > best) best = quality, seed = i;
    }
    return {sum, seed};
  }

  /** Wall points from which on a piece counts. */
  double leastPiece() const { return fitted::kMinPieceShare * double(map_.walls.size()); }

  /** Finds one more piece by one of the `others`, and removes it; false where there is none. */
  bool followPiece(const Transform2D& first, std::vector<Transform2D>& others) {
    ++layer_;
    nextLayer();
    double best = leastPiece();
    std::optional<std::size_t> chosen;
    std::uint32_t seed = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const auto [sum, patch] = fitOf(others[i], first);
      if (sum > best) best = sum, chosen = i, seed = patch;
    }
    if (!chosen) return false;
    offer(seed, others[*chosen], kMajority, false);
    others.erase(others.begin() + std::ptrdiff_t(*chosen));
    const std::size_t before = result_.patches.size();
    twice_ = 0;
    const double walls = grow(kMajority);
    if (walls < leastPiece())
      result_.patches.resize(before);
    else if (!(map_.hasScans && other_.hasScans) && !speaksForItself(first, walls))
      giveBack(before);
    return true;
  }

  /** Whether a piece is needed beside the `first` pose: buildings repeat themselves. Walls that lie
   *  on walls where the first pose has them say nothing; nor do those whose place there the other
   *  map does not know, if another part explains what they have found. A torn run that has come
   *  back does the same: where there are scans, they decide. */
  bool speaksForItself(const Transform2D& first, double walls) const {
    const auto isFound = [&](std::size_t k) { return foundIn_[k] == layer_; };
    const WallShare share = shareOfChosen(map_, isFound, other_, first);
    if (walls - share.found < leastPiece()) return false;
    return twice_ < kSureQuality * walls || share.known >= fitted::kMinKnown * share.all;
  }

  /** Forgets what this layer has found, from this patch of the result on. */
  void giveBack(std::size_t before) {
    result_.patches.resize(before);
    std::replace(foundIn_.begin(), foundIn_.end(), layer_, kNone);
    std::replace(explainedIn_.begin(), explainedIn_.end(), layer_, kNone);
  }

  /** Looks for the second copy of what was found, and for patches that little is left of. */
  void followTwins() {
    ++layer_;
    nextLayer();
    const std::vector<FollowedPatch> found = result_.patches;
    for (const FollowedPatch& f : found) {
      offer(f.patch, f.pose, kFairQuality, true);
      offerAround(f.patch, f.pose, kFairQuality);
    }
    grow(kFairQuality);
  }

  /** Takes the end of a run that is torn off, if it draws what is there already, unlike walls of a
   *  sound map over which the other one has drawn. Whether it does. Maps that bend by more than
   *  walls may be off contradict each other all along. */
  bool followTornEnd() {
    if (result_.bend > kSameWhereBent) return false;
    const auto isFound = mapped(foundIn_, [](int layer) { return layer != kNone; });
    const auto end = findTornEnd(map_, other_, result_, isFound);
    if (!end) return false;
    layer_ = kTornLayer, twice_ = 0;
    const std::size_t before = result_.patches.size();
    double sum = 0;
    for (const std::uint32_t patch : end->patches) sum += take({1, patch, end->pose});
    const bool isDrawnTwice = twice_ > fitted::kDrawnTwice * sum;
    if (!isDrawnTwice) giveBack(before);
    return isDrawnTwice;
  }

  /** The pose that carries all patches as near to their places as one pose can, and what is left.
   */
  void fit() {
    MotionFit fit;
    for (const FollowedPatch& f : result_.patches) {
      const Point middle = patches_[f.patch].middle;
      fit.add(middle, f.pose(middle), f.walls);
    }
    if (fit.weight() <= 0) return;
    result_.pose = fit.motion();
    double squares = 0;
    for (const FollowedPatch& f : result_.patches) {
      const Point middle = patches_[f.patch].middle;
      squares += f.walls * squaredNorm(result_.pose(middle) - f.pose(middle));
    }
    result_.bend = std::sqrt(squares / fit.weight());
    result_.share = fit.weight() / double(map_.walls.size());
    result_.misfit = misfitAt(map_, other_, result_.pose);
  }

  const WallMap &map_, &other_;
  const WallPatches& patches_;
  static constexpr int kNone = -1;
  std::vector<int> foundIn_;      // the layer that has found a wall point of the map
  std::vector<int> explainedIn_;  // the first layer to find one on this wall point of the other
  double twice_ = 0;              // wall points of a layer on what another one explains
  std::vector<std::vector<std::uint32_t>> left_;  // of `around`, per patch
  std::vector<bool> isDone_;
  std::vector<double> queued_;  // best quality that waits, per patch
  std::priority_queue<Offer> queue_;
  int layer_ = 0;
  FollowedWalls result_;
};

}  // namespace

FollowedWalls followWalls(const WallMap& map, const WallMap& other,
                          const std::vector<Transform2D>& poses) {
  return Follower(map, other).follow(poses);
}

}  // namespace roomgraph
