#include "roomgraph/align/verify_alignment.h"

#include <algorithm>
#include <cmath>

namespace roomgraph {
namespace {

// How far from the end of the free space a wall must lie to speak against a pose [m].
constexpr double kShallow = 0.2, kDeep = 0.5;

constexpr double kBentNoise = 0.4;  // how far apart the same wall lies in bent maps [m]

/** The sums over wall points, and of n nT over those that were found. */
struct FoundSums : AlignmentEvidence {
  double xx = 0, xy = 0, yy = 0;

  void lookUp(const WallMap& other, Point place, Point normal, double length, double noise) {
    all += length;
    const std::size_t i = cellIndexAt(other.frame, place);
    if (i == other.states.size()) return;
    const WallPoint* wall = nearestWall(other, i, normal);
    double foundClose = 0, foundLoose = 0;
    if (wall) {
      const double d2 = squaredNorm(wall->place - place);
      const double facing = std::max(0.0, dot(wall->normal, normal));
      foundClose = facing * std::exp(-0.5 * d2 / (noise * noise));
      foundLoose = facing * std::exp(-0.5 * d2 / (kBentNoise * kBentNoise));
    }
    close += length * foundClose;
    loose += length * foundLoose;
    xx += length * foundLoose * normal.x * normal.x;
    xy += length * foundLoose * normal.x * normal.y;
    yy += length * foundLoose * normal.y * normal.y;
    const bool isKnown = other.states[i] != State::unknown;
    known += length * (isKnown ? 1 : foundLoose);
    if (other.depths[i] > kShallow) slightly += length * (1 - std::min(1.0, 2 * foundClose));
    if (other.depths[i] > kDeep) contradicted += length * (1 - foundLoose);
  }
};

void lookUpAll(const WallMap& map, const WallMap& other, const Transform2D& pose, const Look& look,
               double turn, FoundSums& sums) {
  const std::size_t stride = strideOf(map, look.verifyPoints);
  if (stride == 0) return;
  const double length = double(stride) * map.wallSpacing();
  const Motion2D motion(pose);
  FoundSums part;
  for (std::size_t i = 0; i < map.walls.size(); i += stride)
    part.lookUp(other, motion(map.walls[i].place), motion.turned(map.walls[i].normal), length,
                look.noise);
  // n nT in the frame of a, whichever map was looked up
  const double ct = std::cos(turn), st = std::sin(turn);
  const double xx = part.xx, xy = part.xy, yy = part.yy;
  part.xx = ct * ct * xx - 2 * ct * st * xy + st * st * yy;
  part.yy = st * st * xx + 2 * ct * st * xy + ct * ct * yy;
  part.xy = ct * st * (xx - yy) + (ct * ct - st * st) * xy;
  sums.close += part.close, sums.loose += part.loose, sums.contradicted += part.contradicted;
  sums.slightly += part.slightly, sums.known += part.known, sums.all += part.all;
  sums.xx += part.xx, sums.xy += part.xy, sums.yy += part.yy;
}

struct FreeCount {
  std::size_t free = 0, wall = 0, all = 0;
};

FreeCount countFree(const WallMap& map, const WallMap& other, const Transform2D& pose,
                    std::size_t maxCount) {
  const std::size_t stride = (map.freeCells.size() + maxCount - 1) / maxCount;
  const Motion2D motion(pose);
  FreeCount count;
  for (std::size_t i = 0; i < map.freeCells.size(); i += std::max<std::size_t>(1, stride)) {
    ++count.all;
    const std::size_t cell = cellIndexAt(other.frame, motion(map.placeOf(map.freeCells[i])));
    if (cell == other.states.size()) continue;
    const State state = other.states[cell];
    if (state == State::free) ++count.free;
    if (state == State::occupied) ++count.wall;
  }
  return count;
}

double commonArea(const WallMap& map, const FreeCount& count) {
  return count.all ? map.freeArea * double(count.free + count.wall) / double(count.all) : 0;
}

}  // namespace

AlignmentEvidence verifyAlignment(const WallMap& a, const WallMap& b, const Transform2D& pose,
                                  const Look& look) {
  const Transform2D back = pose.inverse();
  FoundSums sums;
  lookUpAll(b, a, pose, look, 0, sums);
  lookUpAll(a, b, back, look, pose.phi, sums);
  AlignmentEvidence e = sums;
  const double half = 0.5 * (sums.xx + sums.yy);
  e.weakest = half - std::hypot(0.5 * (sums.xx - sums.yy), sums.xy);
  const std::size_t maxCount = 2 * std::size_t(look.verifyPoints);
  const FreeCount inA = countFree(b, a, pose, maxCount), inB = countFree(a, b, back, maxCount);
  const FreeCount& smaller = b.freeArea <= a.freeArea ? inA : inB;
  if (smaller.all > 0) e.overlap = double(smaller.free) / double(smaller.all);
  const FreeCount free{inA.free + inB.free, inA.wall + inB.wall, 0};
  e.common = commonArea(b, inA) + commonArea(a, inB);
  if (free.free + free.wall > 0) e.freeOnWall = double(free.wall) / double(free.free + free.wall);
  return e;
}

}  // namespace roomgraph
