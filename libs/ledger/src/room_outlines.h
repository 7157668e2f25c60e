#pragma once
#include <cstdint>
#include <vector>

#include "fit_shape.h"

namespace roomgraph {

/** Places along an outline, ready to be measured against. */
class RoomOutline {
 public:
  static constexpr double kReach = 0.5;  ///< places farther away are not found [m]

  explicit RoomOutline(const Polygon& polygon);

  const std::vector<Point>& places() const { return places_; }
  /** The nearest place within kReach; null for none. O(1). */
  const Point* nearest(Point p) const;
  /** Across the outline at a place of it, of length 1. */
  Point normal(const Point* place) const { return normals_[std::size_t(place - places_.data())]; }

 private:
  void addRing(const Ring& ring);

  std::vector<Point> places_, normals_;
  GridFrame frame_;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

/** Lays the outline of a room on that of the same room in a run, from `move` on: iterated closest
 *  points across the outline, those farther than 0.1 m count less. `middle` of the room. An outline
 *  on itself stays. Deterministic. */
RoomMove refinedMove(const RoomOutline& room, const RoomOutline& inRun, RoomMove move,
                     Point middle);

/** Share of the places of both outlines that lie within `near` [m] of the other one; `toB` is
 *  b <- a. O(places). */
double outlineAgreement(const RoomOutline& a, const RoomOutline& b, const Transform2D& toB,
                        double near);

/** The outline with fewer corners: none of those left out is farther than `tolerance` from it. */
Ring simplified(const Ring& ring, double tolerance);
Polygon simplified(const Polygon& polygon, double tolerance);

/** The largest distance of two places of the outline [m]: how long a corridor is, end to end. */
double lengthOf(const Polygon& polygon);

}  // namespace roomgraph
