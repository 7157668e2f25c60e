#include "roomgraph/breaks/find_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

constexpr int kMeansRounds = 12;      // of k-means; it hardly ever takes more than four
constexpr int kSeamRounds = 8;        // in which a centre and what is near it are found in turn
constexpr double kBackground = 1e-6;  // weight of what is far from the seam
constexpr double kAtOrigin = 2;       // how far from where it starts a robot sees most walls [m]
constexpr double kClearance = 0.6;    // that shows that there is room for a robot [m]
constexpr double kTight = 0.05;       // as good as none, as places are not that exact [m]
constexpr std::size_t kFew = 3;       // patches that show that a piece was drawn there
constexpr double kLeastBend = 0.01, kLeastTurn = 0.002;  // of pieces; cells are no finer [m, rad]
constexpr double kMinTurn = 0.03;                        // of a motion that has a centre [rad]

/** The place that `motion` leaves where it is. */
Point centreOf(const Transform2D& motion) {
  // x = R x + t, so x = (I - R)^-1 t.
  const double c = 1 - std::cos(motion.phi), s = std::sin(motion.phi);
  const double scale = 1 / (c * c + s * s);
  return {scale * (c * motion.x - s * motion.y), scale * (s * motion.x + c * motion.y)};
}

/** Parts that hold together more closely, as a break of few degrees leaves them. */
RigidPiecesOptions halfOf(RigidPiecesOptions options) {
  options.maxTurn /= 2, options.maxShift /= 2;
  return options;
}

/** A patch, where it is drawn, and where it really lies. */
struct Placed {
  std::uint32_t patch;
  Point drawn, there;
  double phi;  // by which it was turned
  double walls;
};

using Member = std::vector<int>;  // of each patch: 0 or 1, its piece; -1, none

double away(const Placed& p, const Transform2D& pose) { return distance(pose(p.drawn), p.there); }

/** Two pieces, and how well they explain the patches. */
struct Pieces {
  Member member;
  std::array<Transform2D, 2> poses;
  std::array<double, 2> walls{};
  double bend = 0;      // RMS [m]
  double turnBend = 0;  // RMS [rad]

  double explained() const { return walls[0] + walls[1]; }
};

class PieceFinder {
 public:
  PieceFinder(const WallMap& of, const WallMap& in, const FollowedWalls& followed,
              const FindPiecesOptions& options)
      : in_(in), options_(options) {
    for (const FollowedPatch& f : followed.patches) {
      const Point middle = of.patches[f.patch].middle;
      patches_.push_back({f.patch, middle, f.pose(middle), f.pose.phi, f.walls});
      all_ += f.walls;
    }
    seeds_ = piecesThatHold(of.patches, followed, options.seeds);
    if (seeds_.size() < 2) seeds_ = piecesThatHold(of.patches, followed, halfOf(options.seeds));
    if (seeds_.size() > options.maxSeeds) seeds_.resize(options.maxSeeds);
  }

  std::optional<PieceBreak> find() const {
    std::optional<Pieces> best;
    for (std::size_t i = 0; i < seeds_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (auto pieces = grown(seeds_[i], seeds_[j]); pieces && isBetter(*pieces, best))
          best = std::move(pieces);
    if (!best || best->turnBend > options_.maxTurnBend) return std::nullopt;
    if (atOrigin(*best, 1) > atOrigin(*best, 0)) swapPieces(*best);
    return breakOf(*best);
  }

 private:
  /** One metre of bend counts as much as 30 % of the walls. */
  bool isBetter(const Pieces& pieces, const std::optional<Pieces>& best) const {
    const auto worth = [&](const Pieces& p) { return p.explained() / all_ - 0.3 * p.bend; };
    return !best || worth(pieces) > worth(*best);
  }

  /** How far a patch is from where a piece would have it, 0 to 1; more where it cannot be of it. */
  double misfit(const Placed& p, const Transform2D& pose) const {
    return away(p, pose) / options_.maxAway +
           std::abs(wrappedAngle(p.phi - pose.phi)) / options_.maxTurn;
  }

  /** The two pieces that two seeds grow to; none where one of them comes to be too small. */
  std::optional<Pieces> grown(const std::vector<std::size_t>& one,
                              const std::vector<std::size_t>& other) const {
    Pieces pieces;
    pieces.member.assign(patches_.size(), -1);
    for (const std::size_t k : one) pieces.member[k] = 0;
    for (const std::size_t k : other) pieces.member[k] = 1;
    for (int round = 0; round < kMeansRounds; ++round) {
      fit(pieces);
      Member member;
      for (const Placed& p : patches_) {
        const double a = misfit(p, pieces.poses[0]), b = misfit(p, pieces.poses[1]);
        member.push_back(std::min(a, b) > 1 ? -1 : a <= b ? 0 : 1);
      }
      if (member == pieces.member) break;
      pieces.member = std::move(member);
    }
    fit(pieces);
    measure(pieces);
    const double least = std::min(pieces.walls[0], pieces.walls[1]);
    if (least < options_.minPiece * all_ || pieces.explained() < options_.minExplained * all_)
      return std::nullopt;
    return pieces;
  }

  void fit(Pieces& pieces) const {
    for (int k : {0, 1}) pieces.poses[std::size_t(k)] = poseOf(pieces.member, k, std::nullopt);
  }

  /** The pose of a piece, or that of what it has near a place. */
  Transform2D poseOf(const Member& member, int piece, std::optional<Point> at) const {
    MotionFit fit;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (member[i] != piece) continue;
      const Placed& p = patches_[i];
      const double far = at ? distance(p.drawn, *at) / options_.atSeam : 0;
      fit.add(p.drawn, p.there, p.walls * (std::exp(-far * far / 2) + kBackground));
    }
    return fit.motion();
  }

  void measure(Pieces& pieces) const {
    double squares = 0, turns = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (pieces.member[i] < 0) continue;
      const std::size_t k = std::size_t(pieces.member[i]);
      const Placed& p = patches_[i];
      const double turn = wrappedAngle(p.phi - pieces.poses[k].phi), far = away(p, pieces.poses[k]);
      pieces.walls[k] += p.walls;
      squares += p.walls * far * far;
      turns += p.walls * turn * turn;
    }
    if (pieces.explained() <= 0) return;
    pieces.bend = std::max(kLeastBend, std::sqrt(squares / pieces.explained()));
    pieces.turnBend = std::max(kLeastTurn, std::sqrt(turns / pieces.explained()));
  }

  /** How much of what is near each other in the two pieces holds together, 0 to 1: where they pass
   *  into each other, as those of a map that bends all along do, it is much. */
  double heldShare(const Pieces& pieces) const {
    const double turn = std::abs(wrappedAngle(pieces.poses[1].phi - pieces.poses[0].phi));
    const double heldTurn =
        turn < options_.minRotation ? options_.heldTurn : std::min(options_.heldTurn, turn / 2);
    std::size_t pairs = 0, held = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      for (std::size_t j = 0; j < patches_.size(); ++j) {
        if (pieces.member[i] != 0 || pieces.member[j] != 1) continue;
        const Placed &a = patches_[i], &b = patches_[j];
        if (distance(a.drawn, b.drawn) > options_.seeds.reach) continue;
        ++pairs;
        held += hold(a, b, heldTurn);
      }
    return pairs > 0 ? double(held) / double(pairs) : 0;
  }

  bool hold(const Placed& a, const Placed& b, double maxTurn) const {
    const Point between = midpoint(a.drawn, b.drawn);
    const auto there = [&](const Placed& p) { return carrying(p.drawn, p.there, p.phi)(between); };
    return std::abs(wrappedAngle(a.phi - b.phi)) <= maxTurn &&
           distance(there(a), there(b)) <= options_.heldPlace;
  }

  /** How much of the walls round the origin a piece has drawn. A robot that comes back there after
   *  a break draws them once more; but it starts where there is room for it. */
  double atOrigin(const Pieces& pieces, int piece) const {
    double sum = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const double far = norm(patches_[i].drawn) / kAtOrigin;
      if (pieces.member[i] == piece) sum += patches_[i].walls * std::exp(-far);
    }
    const double clearance = kTight + clearanceAt(pieces.poses[std::size_t(piece)].shift());
    return sum * clearance * clearance;
  }

  /** From a place of the other map to what is not free there, up to what a robot keeps [m]. */
  double clearanceAt(Point there) const {
    const std::size_t cell = cellIndexAt(in_.frame, there);
    return cell < in_.depths.size() ? std::min(kClearance, double(in_.depths[cell])) : 0;
  }

  static void swapPieces(Pieces& pieces) {
    for (int& k : pieces.member)
      if (k >= 0) k = 1 - k;
    std::swap(pieces.poses[0], pieces.poses[1]);
    std::swap(pieces.walls[0], pieces.walls[1]);
  }

  std::optional<PieceBreak> breakOf(const Pieces& pieces) const {
    // What the run did too much: from where the second piece belongs to where it was drawn.
    const Transform2D motion = pieces.poses[1].inverse() * pieces.poses[0];
    PieceBreak found;
    found.bend = pieces.bend;
    found.pieces = {patchesOf(pieces, 0), patchesOf(pieces, 1)};
    if (std::abs(motion.phi) >= options_.minRotation) {
      const Transform2D turn = turnAtSeam(pieces, motion);
      found.rotation = turn.phi;
      found.place = centreOf(turn);
      found.isPlaced = isDrawn(pieces, found.place);
      if (!isClear(pieces, std::abs(turn.phi) / pieces.turnBend)) return std::nullopt;
      return found;
    }
    found.place = seamOf(pieces);
    found.rotation = motion.phi;
    found.shift = distance(motion(found.place), found.place);
    if (found.shift < options_.minShift || !isClear(pieces, found.shift / pieces.bend))
      return std::nullopt;
    return found;
  }

  /** Whether a break that is so many times what its pieces bend is more than that. */
  bool isClear(const Pieces& pieces, double contrast) const {
    return contrast >= options_.minContrast && heldShare(pieces) <= options_.maxHeld * contrast;
  }

  /** The motion between the pieces as what lies round its centre has it. */
  Transform2D turnAtSeam(const Pieces& pieces, Transform2D motion) const {
    for (int round = 0; round < kSeamRounds; ++round) {
      const Point centre = centreOf(motion);
      const Transform2D next =
          poseOf(pieces.member, 1, centre).inverse() * poseOf(pieces.member, 0, centre);
      if (std::abs(next.phi) < kMinTurn) break;
      motion = next;
    }
    return motion;
  }

  std::vector<std::size_t> patchesOf(const Pieces& pieces, int piece) const {
    std::vector<std::size_t> of;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (pieces.member[i] == piece) of.push_back(patches_[i].patch);
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
    return of;
  }

  /** Whether one of the pieces has drawn something round a place. */
  bool isDrawn(const Pieces& pieces, Point place) const {
    for (const int piece : {0, 1}) {
      std::size_t near = 0;
      for (std::size_t i = 0; i < patches_.size(); ++i)
        near +=
            pieces.member[i] == piece && distance(patches_[i].drawn, place) <= options_.maxOutside;
      if (near >= kFew) return true;
    }
    return false;
  }

  /** The middle of the patches that are in both pieces; else of where these come nearest. */
  Point seamOf(const Pieces& pieces) const {
    Point sum, nearest;
    double count = 0, least = HUGE_VAL;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      for (std::size_t j = 0; j < patches_.size(); ++j) {
        if (pieces.member[i] != 0 || pieces.member[j] != 1) continue;
        const Point middle = midpoint(patches_[i].drawn, patches_[j].drawn);
        if (patches_[i].patch == patches_[j].patch) sum = sum + middle, ++count;
        const double far = distance(patches_[i].drawn, patches_[j].drawn);
        if (far < least) least = far, nearest = middle;
      }
    return count > 0 ? (1 / count) * sum : nearest;
  }

  const WallMap& in_;
  const FindPiecesOptions& options_;
  std::vector<Placed> patches_;
  std::vector<std::vector<std::size_t>> seeds_;
  double all_ = 0;
};

}  // namespace

std::optional<PieceBreak> findPieces(const WallMap& of, const WallMap& in,
                                     const FollowedWalls& followed,
                                     const FindPiecesOptions& options) {
  return PieceFinder(of, in, followed, options).find();
}

}  // namespace roomgraph
