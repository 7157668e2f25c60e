#include "roomgraph/repair/BendField.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fitted_repair.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/nearest_wall.h"
#include "roomgraph/base/UnionFind.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/geometry/MotionFit.h"
#include "roomgraph/relate/place_runs.h"

namespace roomgraph {
namespace {

/** The mean of poses that say about the same. */
template <class Words>
Transform2D meanOf(const Words& words, const Transform2D& about) {
  double weight = 0, turn = 0;
  Point sum;
  for (const auto& word : words) {
    weight += word.weight, sum = sum + word.weight * word.pose.shift();
    turn += word.weight * wrappedAngle(word.pose.phi - about.phi);
  }
  return {sum.x / weight, sum.y / weight, wrappedAngle(about.phi + turn / weight)};
}

/** Walls that hang together where they were found. */
struct Piece {
  double walls = 0, bend = 0;  ///< how far they lie from where the first pose leads [m]
};

/** The piece of each patch: beside it another one is turned and shifted alike. */
std::vector<std::uint32_t> piecesOf(const std::vector<FollowedPatch>& found,
                                    const WallPatches& patches) {
  std::vector<std::vector<std::uint32_t>> ofPatch(patches.size());
  for (std::uint32_t i = 0; i < found.size(); ++i) ofPatch[found[i].patch].push_back(i);
  UnionFind pieces(found.size());
  const auto joinTo = [&](std::uint32_t i, std::uint32_t patch) {
    for (const std::uint32_t other : ofPatch[patch])
      if (areNear(found[i].pose, found[other].pose, patches[patch].middle, kNextPatch))
        pieces.join(i, other);
  };
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    joinTo(i, found[i].patch);
    for (const std::uint32_t next : patches[found[i].patch].neighbours) joinTo(i, next);
  }
  std::vector<std::uint32_t> pieceOf;
  for (std::uint32_t i = 0; i < found.size(); ++i) pieceOf.push_back(pieces.find(i));
  return pieceOf;
}

/** Which patches of a map tell how it lies in another. Walls that are left over fit in many places,
 *  so a piece that lies elsewhere has to be more than half of all that does not. */
std::vector<FollowedPatch> believedPatches(const FollowedWalls& followed,
                                           const WallPatches& patches) {
  const std::vector<FollowedPatch>& found = followed.patches;
  MotionFit first;
  for (const FollowedPatch& patch : found) {
    const Point middle = patches[patch.patch].middle;
    if (patch.layer == 0) first.add(middle, patch.pose(middle), patch.walls);
  }
  const Transform2D lead = first.motion();
  const std::vector<std::uint32_t> pieceOf = piecesOf(found, patches);
  std::map<std::uint32_t, Piece> pieces;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Point middle = patches[found[i].patch].middle;
    Piece& piece = pieces[pieceOf[i]];
    piece.walls += found[i].walls;
    piece.bend += found[i].walls * distance(found[i].pose(middle), lead(middle));
  }
  const auto isElsewhere = [](const Piece& piece) {
    return piece.bend > fitted::kOtherPiece * piece.walls;
  };
  double together = 0;
  for (const auto& [id, piece] : pieces)
    if (!isElsewhere(piece)) together += piece.walls;
  std::vector<FollowedPatch> believed;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Piece& piece = pieces[pieceOf[i]];
    if (!isElsewhere(piece) || piece.walls > kMajority * together) believed.push_back(found[i]);
  }
  return believed;
}

/** Of a map in itself. */
std::vector<FollowedPatch> unmovedPatches(const WallPatches& patches) {
  std::vector<FollowedPatch> unmoved(patches.size());
  for (std::uint32_t i = 0; i < patches.size(); ++i) unmoved[i].patch = i;
  return unmoved;
}

}  // namespace

BendField::BendField(const SolvedSite& solved, const RealPoses& poses, std::size_t run, Way way)
    : map_(&solved.site.mapOf(run)), way_(way) {
  const std::vector<ScanWalls>& scans = solved.site.runs[run]->scans;
  const std::vector<Transform2D>& real = poses[run];
  const std::vector<bool> isSeen = solved.consensus.errorOf(run).isSeen;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const Transform2D& was = scans[k].pose;
    Node node{
        way == Way::toSite ? was : real[k], way == Way::toSite ? real[k] : was, isSeen[k], {}};
    const Motion2D back(was.inverse());
    for (const WallPoint& wall : scans[k].walls) {  // and beside it, up to the next wall
      const std::size_t sector = sectorOf(back(wall.place));
      for (const std::size_t step : {std::size_t(0), std::size_t(1), kSectors - 1})
        node.looks.set((sector + step) % kSectors);
    }
    nodes_.push_back(node);
  }
}

std::vector<BendField::Node> BendField::nodesOf(const SolvedSite& solved, std::size_t from,
                                                std::size_t to) {
  const WallPatches& patches = solved.site.mapOf(from).patches;
  const std::vector<FollowedPatch> believed =
      from == to ? unmovedPatches(patches)
                 : believedPatches(followedIn(solved.pairs, from, to), patches);
  std::vector<Node> nodes;
  for (const FollowedPatch& patch : believed) {
    const Point middle = patches[patch.patch].middle;
    const Transform2D node{middle.x, middle.y, 0};
    nodes.push_back({node, patch.pose * node, true, {}});
  }
  return nodes;
}

BendField::BendField(const SolvedSite& solved, std::size_t from, std::size_t to) {
  nodes_ = nodesOf(solved, from, to);
  // Where a map has a place twice, both of them lead back to the one.
  rivals_ = nodesOf(solved, to, from);
  for (Node& node : rivals_) std::swap(node.from, node.to);
}

std::size_t BendField::sectorOf(Point inNode) {
  const double turns = std::atan2(inNode.y, inNode.x) / (2 * M_PI) + 0.5;
  return std::min(std::size_t(turns * double(kSectors)), kSectors - 1);
}

bool BendField::isInSight(const Node& node, Point place, Point carried) const {
  if (!map_) return true;
  const Point inNode = node.from.inverse()(place);
  if (norm(inNode) > kSameWall && !node.looks.test(sectorOf(inNode))) return false;
  const Point eye = way_ == Way::toSite ? node.from.shift() : node.to.shift();
  const Point there = way_ == Way::toSite ? place : carried;
  const double length = distance(eye, there), step = map_->frame.resolution / 2;
  const int steps = int(std::ceil((length - kSameWall) / step));
  for (int i = 0; i < steps; ++i) {
    const double along = i * step;
    const std::size_t cell = cellIndexAt(map_->frame, eye + (along / length) * (there - eye));
    if (cell >= map_->states.size() || map_->states[cell] == State::occupied) return false;
  }
  return true;
}

std::vector<BendField::Word> BendField::wordsOn(const Transform2D& place) const {
  std::vector<Word> words;
  double nearest = HUGE_VAL;
  for (const Node& node : nodes_) {
    const double far = distance(node.from.shift(), place.shift());
    if (far > fitted::kEarshot) continue;
    Word word;
    word.pose = node.to * node.from.inverse() * place, word.distance = far;
    word.isSeen = isInSight(node, place.shift(), word.pose.shift()), word.isKnown = node.isKnown;
    if (word.isSeen) nearest = std::min(nearest, far);
    words.push_back(word);
  }
  if (nearest == HUGE_VAL)
    for (const Word& word : words) nearest = std::min(nearest, word.distance);
  for (Word& word : words) {
    const double behind = std::max(0.0, word.distance - nearest) / fitted::kBlend;
    word.weight = std::exp(-0.5 * behind * behind) * (word.isSeen ? 1 : fitted::kUnseen);
  }
  return words;
}

double BendField::rivalOf(Point about, const Transform2D& place,
                          const std::vector<Word>& words) const {
  double rival = 0;
  for (const Word& word : words)
    if (word.distance < (word.isSeen ? 2 : 1) * fitted::kMeant)
      rival = std::max(rival, distance(word.pose.shift(), about));
  for (const Node& node : rivals_)
    if (distance(node.from.shift(), place.shift()) < fitted::kMeant)
      rival = std::max(rival, distance((node.to * node.from.inverse() * place).shift(), about));
  return rival;
}

std::optional<BendField::Carried> BendField::operator()(const Transform2D& place) const {
  std::vector<Word> words = wordsOn(place);
  if (words.empty()) return std::nullopt;
  const auto support = [&](const Word& about) {
    double sum = 0;
    for (const Word& word : words)
      if (distance(word.pose.shift(), about.pose.shift()) < kSameCopy) sum += word.weight;
    return sum;
  };
  // Where a map has the place twice, nothing tells which is meant: the nearest key frame's.
  const Word& first =
      *std::min_element(words.begin(), words.end(), [](const Word& l, const Word& r) {
        return std::make_pair(!l.isSeen, l.distance) < std::make_pair(!r.isSeen, r.distance);
      });
  const Transform2D about = first.pose;
  const double most = support(first), heaviest = first.weight;
  Carried carried;
  carried.rival = rivalOf(about.shift(), place, words);
  eraseIf(words, [&](const Word& word) {
    return distance(word.pose.shift(), about.shift()) >= kSameCopy;
  });
  carried.pose = meanOf(words, about);
  carried.nearest = HUGE_VAL;
  double squares = 0, farthest = HUGE_VAL;
  for (const Word& word : words) {
    const Point off = word.pose.shift() - carried.pose.shift();
    squares += word.weight * squaredNorm(off);
    carried.isSeen |= word.isSeen, farthest = std::min(farthest, word.distance);
    if (word.isSeen) carried.nearest = std::min(carried.nearest, word.distance);
    carried.isKnown |= word.isKnown && word.weight > fitted::kUnseen * heaviest;
  }
  if (!carried.isSeen) carried.nearest = farthest;
  carried.spread = std::sqrt(squares / most);
  return carried;
}

}  // namespace roomgraph
