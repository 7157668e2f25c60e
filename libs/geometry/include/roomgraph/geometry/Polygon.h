#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "roomgraph/geometry/Point.h"

namespace roomgraph {

/** A closed chain of points; the last is joined to the first and not repeated. */
using Ring = std::vector<Point>;

/** A connected area with holes. The outer ring runs counter-clockwise, the holes clockwise.
 *  Rings may touch themselves and each other in single points, and never cross. */
struct Polygon {
  Ring outer;               ///< counter-clockwise
  std::vector<Ring> holes;  ///< clockwise
};

/** Calls `visit(ring)` for each ring: the outer one, then the holes. */
template <class SomePolygon, class Visit>
void forEachRing(SomePolygon& polygon, const Visit& visit) {
  visit(polygon.outer);
  for (auto& hole : polygon.holes) visit(hole);
}

/** The polygon with `move(p)` in the place of each of its points. */
template <class Move>
[[nodiscard]] Polygon movedBy(Polygon polygon, const Move& move) {
  forEachRing(polygon, [&](Ring& ring) {
    for (Point& p : ring) p = move(p);
  });
  return polygon;
}

/** Calls `visit(a, b)` for each two points that follow each other on a ring, also for the last and
 *  the first. In the order of the rings. */
template <class Visit>
void forEachEdge(const Polygon& polygon, const Visit& visit) {
  forEachRing(polygon, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      visit(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  });
}

/** Area that the ring encloses [m2], positive where it runs counter-clockwise (paper III-G). */
[[nodiscard]] double signedArea(const Ring& ring);

/** Area of the polygon without its holes [m2]. */
[[nodiscard]] double area(const Polygon& polygon);

/** Length of all rings [m]. */
[[nodiscard]] double perimeter(const Polygon& polygon);

/** Centre of mass of the polygon without its holes (paper III-G); the mean of the outer ring's
 *  points where the area is 0. Lies outside of the polygon where that is concave enough. */
[[nodiscard]] Point centroid(const Polygon& polygon);

/** Where a point lies to a polygon. */
enum class Side { inside, onBoundary, outside };

/** Exact for the given coordinates. O(n) in the number of ring points. */
[[nodiscard]] Side sideOf(const Polygon& polygon, Point p);

/** Whether `p` lies on the closed segment a–b. Exact for the given coordinates. */
[[nodiscard]] bool isOnSegment(Point p, Point a, Point b);

/** Whether the ray from `p` in +x crosses a–b. Half open in y, so that of two edges that share an
 *  end on the ray one counts. A point is inside of a ring if the number is odd. Exact. */
[[nodiscard]] bool rayCrosses(Point p, Point a, Point b);

/** An upright box; as it is made, it holds nothing. */
struct Box {
  Point low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};  ///< lower left, upper right [m]

  [[nodiscard]] bool isEmpty() const { return !(low.x <= high.x && low.y <= high.y); }
  [[nodiscard]] Point size() const { return high - low; }  ///< [m]
  /** Grows so that it holds `p` as well. */
  void include(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  /** The box with so much more to each side. */
  [[nodiscard]] Box widened(double margin) const {
    return {low - Point{margin, margin}, high + Point{margin, margin}};
  }
  [[nodiscard]] bool contains(Point p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
};

/** The smallest box round the points; empty for none. */
[[nodiscard]] Box boundingBox(const std::vector<Point>& points);

/** The smallest convex ring round the points, counter-clockwise; empty for none. O(n log n). */
[[nodiscard]] Ring convexHull(std::vector<Point> points);

/** How far apart two parallel lines are at least with a convex ring between them [m]; 0 for less
 *  than three corners. O(corners^2). */
[[nodiscard]] double leastWidth(const Ring& hull);

}  // namespace roomgraph
