#include "roomgraph/breaks/find_pieces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

/** Patches that lie in the other map as one. */
struct Piece {
  Transform2D pose;
  std::vector<const FollowedPatch*> patches;
  double walls = 0;
};

class PieceFinder {
 public:
  PieceFinder(const MapForAlignment& of, const FollowedWalls& followed,
              const FindPiecesOptions& options)
      : of_(of), options_(options) {
    for (const FollowedPatch& patch : followed.patches) {
      left_.push_back(&patch);
      all_ += patch.walls;
    }
  }

  /** The pose that most of what is left shares, with its patches, which are left no more. */
  Piece largest() {
    Piece best;
    for (const FollowedPatch* centre : left_)
      if (Piece piece = around(centre->pose); piece.walls > best.walls) best = std::move(piece);
    for (int i = 0; i < 3 && !best.patches.empty(); ++i) best = around(meanOf(best));
    left_.erase(std::remove_if(left_.begin(), left_.end(),
                               [&](const FollowedPatch* patch) {
                                 return std::find(best.patches.begin(), best.patches.end(),
                                                  patch) != best.patches.end();
                               }),
                left_.end());
    return best;
  }

  double shareOf(const Piece& piece) const { return all_ > 0 ? piece.walls / all_ : 0; }
  Point middleOf(const FollowedPatch& patch) const { return of_.patches[patch.patch].middle; }

 private:
  Piece around(const Transform2D& pose) const {
    Piece piece{pose, {}, 0};
    for (const FollowedPatch* patch : left_) {
      const Point middle = middleOf(*patch);
      if (std::abs(wrappedAngle(patch->pose.phi - pose.phi)) > options_.sameTurn ||
          distance(patch->pose(middle), pose(middle)) > options_.samePlace)
        continue;
      piece.patches.push_back(patch);
      piece.walls += patch->walls;
    }
    return piece;
  }

  Transform2D meanOf(const Piece& piece) const {
    MotionFit fit;
    for (const FollowedPatch* patch : piece.patches)
      fit.add(middleOf(*patch), patch->pose(middleOf(*patch)), patch->walls);
    return fit.motion();
  }

  const MapForAlignment& of_;
  const FindPiecesOptions& options_;
  std::vector<const FollowedPatch*> left_;
  double all_ = 0;
};

double distanceToOrigin(const Piece& piece, const PieceFinder& finder) {
  double least = HUGE_VAL;
  for (const FollowedPatch* patch : piece.patches)
    least = std::min(least, norm(finder.middleOf(*patch)));
  return least;
}

/** The middle of the patches that are in both pieces; else of where these come nearest. */
Point seamOf(const Piece& a, const Piece& b, const PieceFinder& finder) {
  Point sum, nearest;
  double count = 0, least = HUGE_VAL;
  for (const FollowedPatch* p : a.patches)
    for (const FollowedPatch* q : b.patches) {
      const Point middle = midpoint(finder.middleOf(*p), finder.middleOf(*q));
      if (p->patch == q->patch) sum = sum + middle, ++count;
      const double far = distance(finder.middleOf(*p), finder.middleOf(*q));
      if (far < least) least = far, nearest = middle;
    }
  return count > 0 ? (1 / count) * sum : nearest;
}

/** The place that `motion` leaves where it is. */
Point centreOf(const Transform2D& motion) {
  // x = R x + t, so x = (I - R)^-1 t.
  const double c = 1 - std::cos(motion.phi), s = std::sin(motion.phi);
  const double scale = 1 / (c * c + s * s);
  return {scale * (c * motion.x - s * motion.y), scale * (s * motion.x + c * motion.y)};
}

}  // namespace

std::optional<PieceBreak> findPieces(const MapForAlignment& of, const FollowedWalls& followed,
                                     const FindPiecesOptions& options) {
  PieceFinder finder(of, followed, options);
  Piece first = finder.largest(), second = finder.largest();
  if (finder.shareOf(second) < options.minPiece ||
      finder.shareOf(first) + finder.shareOf(second) < options.minExplained)
    return std::nullopt;
  if (distanceToOrigin(second, finder) < distanceToOrigin(first, finder)) std::swap(first, second);
  // What the run did too much: from where the second piece belongs to where it was drawn.
  const Transform2D motion = second.pose.inverse() * first.pose;
  PieceBreak found{seamOf(first, second, finder), motion.phi, 0, first.pose};
  found.shift = distance(motion(found.place), found.place);
  if (std::abs(motion.phi) >= options.minRotation) {
    found.place = centreOf(motion);
    found.shift = 0;
    return found;
  }
  if (found.shift < options.minShift) return std::nullopt;
  return found;
}

}  // namespace roomgraph
