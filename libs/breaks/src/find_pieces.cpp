#include "roomgraph/breaks/find_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fitted_breaks.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/breaks/MapBreak.h"
#include "roomgraph/geometry/MotionFit.h"
#include "roomgraph/geometry/NearPlaces.h"

namespace roomgraph {
namespace {

/** The place that `motion` leaves where it is. */
Point centreOf(const Transform2D& motion) {
  // x = R x + t, so x = (I - R)^-1 t.
  const double c = 1 - std::cos(motion.phi), s = std::sin(motion.phi);
  const double scale = 1 / (c * c + s * s);
  return {scale * (c * motion.x - s * motion.y), scale * (s * motion.x + c * motion.y)};
}

using Members = std::vector<int>;  // of each patch that was found: 0 or 1, its piece; -1, none

/** Two pieces, and how well they explain the patches. */
struct Pieces {
  Members members;
  std::array<Transform2D, 2> poses;
  std::array<double, 2> walls{};
  double bend = 0;      // RMS [m]
  double turnBend = 0;  // RMS [rad]

  double explained() const { return walls[0] + walls[1]; }
};

class PieceFinder {
 public:
  PieceFinder(const WallPatches& patches, const FollowedWalls& followed,
              const FindBreaksOptions& options)
      : patches_(patches), followed_(followed), options_(options) {
    for (const FollowedPatch& f : followed.patches) all_ += f.walls;
  }

  std::optional<PieceBreak> find() const {
    const auto seeds = rigidPieces(patches_, followed_);
    std::optional<Pieces> best;
    for (std::size_t i = 0; i < seeds.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (auto pieces = grown(seeds[i], seeds[j]); pieces && isBetter(*pieces, best))
          best = std::move(pieces);
    std::optional<PieceBreak> found;
    if (best && best->turnBend <= kBreakRotation) found = breakOf(*best);
    return found ? found : tornOff();
  }

 private:
  Point middleOf(const FollowedPatch& f) const { return patches_[f.patch].middle; }
  double away(const FollowedPatch& f, const Transform2D& pose) const {
    return distance(pose(middleOf(f)), f.pose(middleOf(f)));
  }

  /** One metre of bend counts as much as 30 % of the walls. */
  bool isBetter(const Pieces& pieces, const std::optional<Pieces>& best) const {
    const auto worth = [&](const Pieces& p) { return p.explained() / all_ - 0.3 * p.bend; };
    return !best || worth(pieces) > worth(*best);
  }

  /** How far a patch is from where a piece would have it, 0 to 1; more where it cannot be of it. */
  double misfit(const FollowedPatch& f, const Transform2D& pose) const {
    return away(f, pose) / fitted::kOfPiece.place +
           std::abs(wrappedAngle(f.pose.phi - pose.phi)) / fitted::kOfPiece.turn;
  }

  /** The two pieces that two seeds grow to; none where one of them comes to be too small. */
  std::optional<Pieces> grown(const std::vector<std::size_t>& one,
                              const std::vector<std::size_t>& other) const {
    Pieces pieces;
    pieces.members.assign(followed_.patches.size(), -1);
    for (const std::size_t k : one) pieces.members[k] = 0;
    for (const std::size_t k : other) pieces.members[k] = 1;
    for (int round = 0; round < 12; ++round) {  // it hardly ever takes more than four
      fit(pieces);
      Members members;
      for (const FollowedPatch& f : followed_.patches) {
        const double a = misfit(f, pieces.poses[0]), b = misfit(f, pieces.poses[1]);
        members.push_back(std::min(a, b) > 1 ? -1 : a <= b ? 0 : 1);
      }
      if (members == pieces.members) break;
      pieces.members = std::move(members);
    }
    fit(pieces);
    measure(pieces);
    if (std::min(pieces.walls[0], pieces.walls[1]) < kSmallestPiece * all_) return std::nullopt;
    return pieces;
  }

  /** A short stretch that the other map contradicts where it was drawn, beside all the rest. */
  std::optional<PieceBreak> tornOff() const {
    Pieces pieces;
    for (const FollowedPatch& f : followed_.patches)
      pieces.members.push_back(f.layer == kTornLayer ? 1 : f.layer == 0 ? 0 : -1);
    if (!contains(pieces.members, 1)) return std::nullopt;
    fit(pieces), measure(pieces);
    return breakOf(pieces);
  }

  void fit(Pieces& pieces) const {
    std::array<MotionFit, 2> fits;
    for (std::size_t i = 0; i < pieces.members.size(); ++i) {
      if (pieces.members[i] < 0) continue;
      const FollowedPatch& f = followed_.patches[i];
      fits[std::size_t(pieces.members[i])].add(middleOf(f), f.pose(middleOf(f)), f.walls);
    }
    pieces.poses = {fits[0].motion(), fits[1].motion()};
  }

  void measure(Pieces& pieces) const {
    double squares = 0, turns = 0;
    for (std::size_t i = 0; i < pieces.members.size(); ++i) {
      if (pieces.members[i] < 0) continue;
      const FollowedPatch& f = followed_.patches[i];
      const auto k = std::size_t(pieces.members[i]);
      const double turn = wrappedAngle(f.pose.phi - pieces.poses[k].phi);
      const double far = away(f, pieces.poses[k]);
      pieces.walls[k] += f.walls;
      squares += f.walls * far * far;
      turns += f.walls * turn * turn;
    }
    if (pieces.explained() <= 0) return;
    pieces.bend = std::sqrt(squares / pieces.explained());
    pieces.turnBend = std::sqrt(turns / pieces.explained());
  }

  /** What lies on either side of the seam. */
  struct Seam {
    Point middle;     // halfway between where the pieces come nearest
    double held = 0;  // how much of what is near each other holds together, 0 to 1: where the
                      // pieces pass into each other, as in a map that bends all along, it is much
  };

  Seam seamOf(const Pieces& pieces, const PoseTolerance& heldWithin) const {
    Seam seam;
    double nearest = HUGE_VAL, near = 0;
    for (std::size_t i = 0; i < pieces.members.size(); ++i)
      for (std::size_t j = 0; j < pieces.members.size(); ++j) {
        if (pieces.members[i] != 0 || pieces.members[j] != 1) continue;
        const FollowedPatch &f = followed_.patches[i], &g = followed_.patches[j];
        const double far = distance(middleOf(f), middleOf(g));
        const Point between = midpoint(middleOf(f), middleOf(g));
        if (far < nearest) nearest = far, seam.middle = between;
        if (far > fitted::kPieceReach) continue;
        ++near;
        if (areNear(f.pose, g.pose, between, heldWithin)) ++seam.held;
      }
    if (near > 0) seam.held /= near;
    return seam;
  }

  std::optional<PieceBreak> breakOf(const Pieces& pieces) const {
    const std::size_t larger = pieces.walls[0] >= pieces.walls[1] ? 0 : 1;
    // What the run did too much: from where the smaller piece belongs to where it was drawn.
    const Transform2D motion = pieces.poses[1 - larger].inverse() * pieces.poses[larger];
    const bool isTurned = std::abs(motion.phi) >= std::max(kBreakRotation, options_.minRotation);
    PoseTolerance heldWithin = kSameScanStart;
    if (isTurned) heldWithin.turn = std::min(heldWithin.turn, std::abs(motion.phi) / 2);
    const Seam seam = seamOf(pieces, heldWithin);
    PieceBreak found;
    found.place = isTurned ? centreOf(motion) : seam.middle;
    found.rotation = motion.phi;
    found.shift = isTurned ? 0 : distance(motion(seam.middle), seam.middle);
    found.bend = pieces.bend;
    found.pieces = {patchesOf(pieces, larger), patchesOf(pieces, 1 - larger)};
    const double size = isTurned ? std::abs(motion.phi) : found.shift;
    const double bend = isTurned ? pieces.turnBend : pieces.bend;
    const bool isClear =
        size >= kPieceContrast * bend && seam.held * bend <= fitted::kMostHeld * size;
    if (!isClear || (!isTurned && size < options_.minShift)) return std::nullopt;
    return found;
  }

  std::vector<std::size_t> patchesOf(const Pieces& pieces, std::size_t piece) const {
    std::vector<std::size_t> of;
    for (std::size_t i = 0; i < pieces.members.size(); ++i)
      if (pieces.members[i] == int(piece)) of.push_back(followed_.patches[i].patch);
    sortUnique(of);
    return of;
  }

  const WallPatches& patches_;
  const FollowedWalls& followed_;
  const FindBreaksOptions& options_;
  double all_ = 0;
};

}  // namespace

std::vector<std::vector<std::size_t>> rigidPieces(const WallPatches& patches,
                                                  const FollowedWalls& followed) {
  const std::vector<FollowedPatch>& found = followed.patches;
  const auto holdTogether = [&](const FollowedPatch& f, const FollowedPatch& g) {
    const Point a = patches[f.patch].middle, b = patches[g.patch].middle;
    return distance(a, b) <= fitted::kPieceReach &&
           areNear(f.pose, g.pose, midpoint(a, b), kSameScanAnswer);
  };
  UnionFind sets(found.size());
  const auto middles =
      mapped(found, [&](const FollowedPatch& f) { return patches[f.patch].middle; });
  const NearPlaces near(middles, fitted::kPieceReach);
  double all = 0;
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    all += found[i].walls;
    near.forEachNear(middles[i], [&](std::uint32_t j) {
      if (j < i && holdTogether(found[i], found[j])) sets.join(i, j);
    });
  }
  std::vector<std::vector<std::size_t>> pieces = sets.sets();
  std::vector<double> walls(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) walls[sets.find(i)] += found[i].walls;
  const auto wallsOf = [&](const std::vector<std::size_t>& piece) {
    return walls[piece.front()];  // a set is known by its first member
  };
  eraseIf(pieces, [&](const auto& piece) { return wallsOf(piece) < fitted::kLeastPiece * all; });
  sortDownBy(pieces, wallsOf);
  return pieces;
}

std::optional<PieceBreak> findPieces(const WallPatches& patches, const FollowedWalls& followed,
                                     const FindBreaksOptions& options) {
  return PieceFinder(patches, followed, options).find();
}

}  // namespace roomgraph
