#include "roomgraph/geometry/Polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace roomgraph {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/** Twice the signed area and six times the first moments of a ring, about `origin`. */
struct Moments {
  double area2 = 0, x6 = 0, y6 = 0;
};

// About a near origin, so that maps far from the frame's origin lose no digits.
void addMoments(const Ring& ring, Point origin, Moments& sum) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - origin;
    const Point b = ring[i + 1 < ring.size() ? i + 1 : 0] - origin;
    const double c = cross(a, b);
    sum.area2 += c;
    sum.x6 += (a.x + b.x) * c;
    sum.y6 += (a.y + b.y) * c;
  }
}

enum class RingSide { even, odd, on };

RingSide crossings(const Ring& ring, Point p) {
  bool isOdd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (isOnSegment(p, a, b)) return RingSide::on;
    if (rayCrosses(p, a, b)) isOdd = !isOdd;
  }
  return isOdd ? RingSide::odd : RingSide::even;
}

}  // namespace

bool isOnSegment(Point p, Point a, Point b) {
  using P = Kernel::Point_2;
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y) &&
         CGAL::orientation(P(a.x, a.y), P(b.x, b.y), P(p.x, p.y)) == CGAL::COLLINEAR;
}

bool rayCrosses(Point p, Point a, Point b) {
  if ((a.y > p.y) == (b.y > p.y)) return false;
  if (a.y > b.y) std::swap(a, b);
  using P = Kernel::Point_2;
  return CGAL::orientation(P(a.x, a.y), P(b.x, b.y), P(p.x, p.y)) == CGAL::LEFT_TURN;
}

double signedArea(const Ring& ring) {
  if (ring.empty()) return 0;
  Moments sum;
  addMoments(ring, ring.front(), sum);
  return sum.area2 / 2;
}

double area(const Polygon& polygon) {
  double sum = signedArea(polygon.outer);
  for (const Ring& hole : polygon.holes) sum += signedArea(hole);
  return sum;
}

double perimeter(const Polygon& polygon) {
  double sum = 0;
  forEachEdge(polygon, [&](Point a, Point b) { sum += distance(a, b); });
  return sum;
}

Point centroid(const Polygon& polygon) {
  const Point origin = polygon.outer.front();
  Moments sum;
  forEachRing(polygon, [&](const Ring& ring) { addMoments(ring, origin, sum); });
  if (sum.area2 != 0) return origin + (1 / (3 * sum.area2)) * Point{sum.x6, sum.y6};
  Point mean;
  for (const Point p : polygon.outer) mean = mean + (1.0 / double(polygon.outer.size())) * p;
  return mean;
}

Side sideOf(const Polygon& polygon, Point p) {
  const RingSide outer = crossings(polygon.outer, p);
  if (outer == RingSide::on) return Side::onBoundary;
  if (outer == RingSide::even) return Side::outside;
  for (const Ring& hole : polygon.holes) {
    const RingSide inner = crossings(hole, p);
    if (inner == RingSide::on) return Side::onBoundary;
    if (inner == RingSide::odd) return Side::outside;
  }
  return Side::inside;
}

Box boundingBox(const std::vector<Point>& points) {
  Box box;
  for (const Point p : points) box.include(p);
  return box;
}

Ring convexHull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  Ring hull;
  for (int side = 0; side < 2; ++side) {  // below, then above
    const std::size_t least = std::max<std::size_t>(hull.size(), 1);
    for (const Point p : points) {
      while (hull.size() > least && cross(hull.back() - *(hull.end() - 2), p - hull.back()) <= 0)
        hull.pop_back();
      if (hull.empty() || !(hull.back() == p)) hull.push_back(p);
    }
    std::reverse(points.begin(), points.end());
  }
  if (hull.size() > 1) hull.pop_back();  // the first one once more
  return hull;
}

double leastWidth(const Ring& hull) {
  if (hull.size() < 3) return 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point side = hull[i + 1 < hull.size() ? i + 1 : 0] - hull[i];
    double low = 0, high = 0;  // rounding may put corners on either side of a short one
    for (const Point corner : hull) {
      const double across = cross(side, corner - hull[i]) / norm(side);
      low = std::min(low, across), high = std::max(high, across);
    }
    least = std::min(least, high - low);
  }
  return least;
}

}  // namespace roomgraph
