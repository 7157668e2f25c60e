#include "roomgraph/relate/relate_maps.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fitted_relate.h"
#include "roomgraph/align/alignment_confidence.h"
#include "roomgraph/align/near_poses.h"
#include "roomgraph/align/shared_edges.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/relate/PairBend.h"
#include "roomgraph/relate/sight_walls.h"

namespace roomgraph {
namespace {

void mirrorCells(WallMap& map) {
  GridFrame& frame = map.frame;
  for (int y = 0; y < frame.height; ++y) {
    const auto row = map.states.begin() + std::ptrdiff_t(frame.index({0, y}));
    std::reverse(row, row + frame.width);
  }
  for (std::uint32_t& cell : map.freeCells) {
    const auto width = std::uint32_t(frame.width);
    cell = cell - cell % width + (width - 1 - cell % width);
  }
  frame.origin.x = -(frame.origin.x + frame.width * frame.resolution);
}

void mirrorWalls(WallMap& map) {
  for (WallPoint& wall : map.walls) wall.place.x = -wall.place.x, wall.normal.x = -wall.normal.x;
  const auto key = [&](const WallPoint& wall) {
    return std::make_tuple(map.frame.index(map.frame.cellAt(wall.place)), octantOf(wall.normal),
                           wall.place.x, wall.place.y);
  };
  std::sort(map.walls.begin(), map.walls.end(),
            [&](const WallPoint& l, const WallPoint& r) { return key(l) < key(r); });
  map.patches = wallPatches(map.walls);
}

/** Bin k holds the turns from k to k + 1 steps, so that of half a turn less these is k + 1 from the
 *  other end. */
void mirrorTurns(std::vector<double>& turns) {
  std::vector<double> mirrored(turns.size());
  const std::size_t bins = turns.size();
  for (std::size_t k = 0; k < bins; ++k) mirrored[(bins + bins / 2 - 1 - k) % bins] = turns[k];
  turns = std::move(mirrored);
}

/** All patches at `pose`: where two maps are the same, following could only blur that. */
FollowedWalls carried(const WallMap& map, const Transform2D& pose) {
  FollowedWalls all;
  for (std::uint32_t i = 0; i < map.patches.size(); ++i)
    all.patches.push_back({i, pose, double(map.patches[i].own.size()), 0});
  all.pose = pose;
  all.share = 1;
  return all;
}

/** In a symmetric building the runner-up may be right as well. */
bool isSure(const MapPair& pair) {
  return pair.alignment.confidence >= kMajority &&
         pair.alignment.runnerUpConfidence < fitted::kUnlikely;
}

/** Whether b fits better as its own mirror image. One that surely fits as it is is not asked, so
 *  that only pairs in doubt cost a second search. */
bool isMirrored(const WallMap& a, const WallMap& b, const Alignment& alignment) {
  if (alignment.isSameSite && alignment.confidence >= kSureConfidence) return false;
  const Alignment image = alignMaps(a, mirrored(b));
  return image.isSameSite && image.best->score >= alignment.best->score + fitted::kClearlyMirrored;
}

/** What is to be known of two maps beside their alignment. */
void compare(MapPair& pair, const WallMap& a, const WallMap& b, bool areOneSite = false) {
  const Alignment& alignment = pair.alignment;
  pair.areIdentical = areIdentical(a, b);
  if (!alignment.isSameSite) return;
  std::vector<Transform2D> likeliest{alignment.pose};
  if (alignment.runnerUp) likeliest.push_back(alignment.runnerUp->pose);
  pair.areEdits = pair.areIdentical || areEdits(a.edges, b.edges, likeliest);
  follow(pair, a, b, alignment.poses);
  const bool looksLikeStoreys = areStoreys(pair, a, b);
  pair.alignment.isOnlySaid |= looksLikeStoreys && areOneSite;
  pair.areStoreys = looksLikeStoreys && !areOneSite;
  if (!pair.areStoreys) return;
  pair.alignment.isSameSite = false;
  pair.bInA = pair.aInB = {};
}

/** The poses of the map's pieces in the hub (hub <- map), largest first. */
std::vector<Transform2D> piecesInHub(const MapPair& hubAndMap, const WallMap& map) {
  struct Piece {
    Transform2D pose;
    double walls;
  };
  std::vector<Piece> pieces;
  for (const FollowedPatch& f : hubAndMap.bInA.patches) {
    const Point middle = map.patches[f.patch].middle;
    const auto same = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return areNear(piece.pose, f.pose, middle, kSameScanStart);
    });
    if (same == pieces.end())
      pieces.push_back({f.pose, f.walls});
    else
      same->walls += f.walls;
  }
  sortDownBy(pieces, &Piece::walls);
  std::vector<Transform2D> poses;
  for (std::size_t i = 0; i < std::min(pieces.size(), fitted::kMostOthers); ++i)
    poses.push_back(pieces[i].pose);
  return poses;
}

/** The pose of the whole map, the other answers to where it lies if that is not sure, and the
 *  poses of its pieces. */
std::vector<Transform2D> posesInHub(const MapPair& hubAndMap, const WallMap& map) {
  std::vector<Transform2D> poses{hubAndMap.alignment.pose};
  if (!isSure(hubAndMap))
    for (const Transform2D& pose : hubAndMap.alignment.poses) {
      if (poses.size() > fitted::kMostOthers) break;
      if (!isNearAny(poses, pose, map.middle(), kSameAnswer)) poses.push_back(pose);
    }
  for (const Transform2D& pose : piecesInHub(hubAndMap, map)) poses.push_back(pose);
  return poses;
}

/** The probability that one of the poses in the hub is right. */
double anyConfidence(const MapPair& pair) {
  const Alignment& alignment = pair.alignment;
  return isSure(pair) ? alignment.confidence : alignment.confidence + alignment.runnerUpConfidence;
}

/** Of the straight walls of `of` that `in` knows, the share where it shows free space; 0 where
 *  there are too few. */
double contradictedShare(const WallMap& of, const WallMap& in, const FollowedWalls& followed) {
  const std::vector<WallSighting> seen = sightWalls(of, in, followed);
  const std::vector<bool> isStraight = straightWalls(of);
  double known = 0, free = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool isFree = seen[i] == WallSighting::free;
    if (!isStraight[i] || (!isFree && seen[i] != WallSighting::found)) continue;
    ++known, free += isFree ? 1 : 0;
  }
  return known >= kFewestWalls ? free / known : 0;
}

}  // namespace

WallMap mirrored(const WallMap& map) {
  WallMap image = map;
  image.edges = {};
  mirrorCells(image);
  mirrorWalls(image);
  mirrorTurns(image.turns);
  if (!map.isBare()) addLookUp(image);
  return image;
}

void takeLikeliest(Alignment& alignment) {
  const double sum = alignment.confidence + alignment.runnerUpConfidence;
  if (sum <= 0 || (alignment.isSameSite && sum >= kMajority)) return;
  if (alignment.runnerUpConfidence >= fitted::kUnlikely * sum) return;
  alignment.isSameSite = alignment.isOnlySaid = true;
  alignment.confidence /= sum, alignment.runnerUpConfidence /= sum;
}

void follow(MapPair& pair, const WallMap& a, const WallMap& b,
            const std::vector<Transform2D>& poses) {
  if (pair.areIdentical) {
    pair.bInA = carried(b, poses.front()), pair.aInB = carried(a, poses.front().inverse());
    return;
  }
  pair.bInA = followWalls(b, a, poses);
  pair.aInB = followWalls(a, b, mapped(poses, &Transform2D::inverse));
}

MapPair swapped(MapPair pair) {
  pair.alignment = inverse(std::move(pair.alignment));
  std::swap(pair.bInA, pair.aInB);
  return pair;
}

MapPair relateMaps(const WallMap& a, const WallMap& b, bool areOneSite) {
  MapPair pair;
  pair.alignment = alignMaps(a, b);
  if (pair.alignment.best && isMirrored(a, b, pair.alignment)) {
    pair.alignment.isMirrored = true, pair.alignment.isSameSite = false;
    pair.alignment.confidence = pair.alignment.siteConfidence = 0;
  } else if (areOneSite) {
    takeLikeliest(pair.alignment);
  }
  compare(pair, a, b, areOneSite);
  return pair;
}

MapPair relateMapsOver(const MapPair& hubAndA, const MapPair& hubAndB, const WallMap& a,
                       const WallMap& b) {
  if (!hubAndA.alignment.isSameSite || !hubAndB.alignment.isSameSite) return relateMaps(a, b);
  std::vector<Transform2D> poses;
  for (const Transform2D& ofB : posesInHub(hubAndB, b))
    for (const Transform2D& ofA : posesInHub(hubAndA, a)) poses.push_back(ofA.inverse() * ofB);
  MapPair pair;
  pair.alignment = alignMapsNear(a, b, poses);
  // One way or another, this pair is no surer than the two that it follows from.
  pair.alignment.confidence =
      std::min({pair.alignment.confidence, anyConfidence(hubAndA), anyConfidence(hubAndB)});
  const bool areSure = isSure(hubAndA) && isSure(hubAndB);
  if (!pair.alignment.isSameSite && areSure) return relateMaps(a, b);
  pair.alignment.isAmbiguous |= hubAndA.alignment.isAmbiguous || hubAndB.alignment.isAmbiguous;
  compare(pair, a, b);
  return pair;
}

Alignment alignmentAt(const WallMap& a, const WallMap& b, std::vector<Transform2D> poses) {
  Alignment alignment;
  alignment.pose = poses.front();
  alignment.best = AlignmentCandidate{alignment.pose, verifyAlignment(a, b, alignment.pose), 0};
  alignment.overlap = alignment.best->evidence.overlap;
  alignment.isSameSite = true;
  alignment.siteConfidence = alignment.confidence = 1;
  alignment.poses = std::move(poses);
  return alignment;
}

MapPair relateAlignedMaps(const WallMap& a, const WallMap& b) {
  MapPair pair;
  pair.alignment = alignmentAt(a, b, {{}});
  Alignment& alignment = pair.alignment;
  alignment.siteConfidence = probability(sameSiteLogOdds(alignment.best->evidence));
  alignment.isSameSite = alignment.siteConfidence >= fitted::kUnlikely;
  if (!alignment.isSameSite) alignment.confidence = alignment.siteConfidence;
  compare(pair, a, b);
  return pair;
}

bool areStoreys(const MapPair& pair, const WallMap& a, const WallMap& b) {
  if (pair.areEdits || pair.alignment.confidence < kSureConfidence) return false;
  if (std::max(pair.bInA.bend, pair.aInB.bend) > fitted::kHardlyBent) return false;
  return contradictedShare(b, a, pair.bInA) >= fitted::kOtherWalls &&
         contradictedShare(a, b, pair.aInB) >= fitted::kOtherWalls;
}

}  // namespace roomgraph
