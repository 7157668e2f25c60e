#include "room_outlines.h"

#include <algorithm>
#include <cmath>

#include "roomgraph/align/WallFit.h"
#include "roomgraph/align/wall_map.h"
#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {
namespace {

/** The corners between `from` and `to` that a line cannot leave out, by halves. */
void keepFar(const Ring& ring, std::size_t from, std::size_t to, double tolerance,
             std::vector<bool>& isKept) {
  std::vector<std::pair<std::size_t, std::size_t>> spans{{from, to}};
  while (!spans.empty()) {
    const auto [low, high] = spans.back();
    spans.pop_back();
    double most = tolerance;
    std::size_t corner = low;
    for (std::size_t i = low + 1; i < high; ++i) {
      const double off = distanceToSegment(ring[i], ring[low], ring[high % ring.size()]);
      if (off > most) most = off, corner = i;
    }
    if (corner == low) continue;
    isKept[corner] = true;
    spans.push_back({low, corner}), spans.push_back({corner, high});
  }
}

/** A step of the room towards the outline in the run: shift, then turn about its middle. */
Eigen::Vector3d stepOf(const RoomOutline& room, const RoomOutline& inRun, const RoomMove& move,
                       Point middle) {
  const Motion2D motion(move.about(middle));
  WallStep<3> step{middle + move.shift, kWallCell};
  double reach = 0;
  for (const Point& place : room.places()) {
    const Point p = motion(place);
    reach += squaredNorm(p - step.pivot);
    if (const Point* nearest = inRun.nearest(p)) step.add(p, {*nearest, inRun.normal(nearest)});
  }
  const double count = double(room.places().size());
  if (count == 0) return step.g;
  return step.solution(kShiftHold * Eigen::Vector3d(count, count, reach + 1e-9));
}

}  // namespace

RoomOutline::RoomOutline(const Polygon& polygon) {
  forEachRing(polygon, [&](const Ring& ring) { addRing(ring); });
  if (places_.empty()) return;
  const Box box = boundingBox(places_);
  const Point size = box.high - box.low;
  frame_ = {int(size.x / kReach) + 1, int(size.y / kReach) + 1, kReach, box.low};
  buckets_.resize(frame_.cellCount());
  for (std::size_t i = 0; i < places_.size(); ++i)
    buckets_[frame_.index(frame_.cellAt(places_[i]))].push_back(std::uint32_t(i));
}

void RoomOutline::addRing(const Ring& ring) {
  const Ring corners = simplified(ring, kWallCell / 2);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    const double length = distance(a, b);
    if (length <= 0) continue;
    const Point along = (1 / length) * (b - a);
    const int count = std::max(1, int(std::lround(length / kWallCell)));
    for (int k = 0; k < count; ++k) {
      places_.push_back(a + ((k + 0.5) / count * length) * along);
      normals_.push_back(toLeft(along));
    }
  }
}

const Point* RoomOutline::nearest(Point p) const {
  const Point* best = nullptr;
  double least = kReach * kReach;
  const Cell cell = frame_.cellAt(p);
  for (int y = cell.y - 1; y <= cell.y + 1; ++y)
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (!frame_.contains({x, y})) continue;
      for (const std::uint32_t i : buckets_[frame_.index({x, y})])
        if (const double d = squaredNorm(places_[i] - p); d < least) least = d, best = &places_[i];
    }
  return best;
}

RoomMove refinedMove(const RoomOutline& room, const RoomOutline& inRun, RoomMove move,
                     Point middle) {
  for (int i = 0; i < 15; ++i) {
    const Eigen::Vector3d step = stepOf(room, inRun, move, middle);
    if (!(step.head<2>().norm() + std::abs(step.z()) > 1e-4)) break;  // by less, nothing moves
    move.shift = move.shift + Point{step.x(), step.y()};
    move.turn += step.z();
  }
  return move;
}

double outlineAgreement(const RoomOutline& a, const RoomOutline& b, const Transform2D& toB,
                        double near) {
  const auto count = [&](const RoomOutline& from, const RoomOutline& to, const Motion2D& motion) {
    double close = 0;
    for (const Point& place : from.places()) {
      const Point p = motion(place);
      const Point* nearest = to.nearest(p);
      if (nearest && squaredNorm(*nearest - p) <= near * near) ++close;
    }
    return close;
  };
  const double all = double(a.places().size() + b.places().size());
  if (all == 0) return 1;
  return (count(a, b, Motion2D(toB)) + count(b, a, Motion2D(toB.inverse()))) / all;
}

Ring simplified(const Ring& ring, double tolerance) {
  if (ring.size() < 4) return ring;
  std::size_t far = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (squaredNorm(ring[i] - ring[0]) > squaredNorm(ring[far] - ring[0])) far = i;
  std::vector<bool> isKept(ring.size() + 1);
  isKept[0] = isKept[far] = true;
  keepFar(ring, 0, far, tolerance, isKept);
  keepFar(ring, far, ring.size(), tolerance, isKept);
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (isKept[i]) result.push_back(ring[i]);
  return result;
}

Polygon simplified(const Polygon& polygon, double tolerance) {
  Polygon result{simplified(polygon.outer, tolerance), {}};
  for (const Ring& hole : polygon.holes)
    if (Ring ring = simplified(hole, tolerance); ring.size() > 2)
      result.holes.push_back(std::move(ring));
  return result;
}

double lengthOf(const Polygon& polygon) {
  const Ring ring = simplified(polygon.outer, 0.02);
  double most = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t k = i + 1; k < ring.size(); ++k)
      most = std::max(most, squaredNorm(ring[i] - ring[k]));
  return std::sqrt(most);
}

}  // namespace roomgraph
