#pragma once
#include <cmath>

namespace roomgraph {

constexpr double kFarthestPlace = 1e11;  ///< beyond all places of maps that can be read [m]

/** A place or a displacement in the plane [m, map frame]. */
struct Point {
  double x = 0, y = 0;  ///< [m]

  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
  friend bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }
  friend bool operator!=(Point a, Point b) { return !(a == b); }
  /** By x, then by y. */
  friend bool operator<(Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }
};

[[nodiscard]] inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
[[nodiscard]] inline double squaredNorm(Point a) { return dot(a, a); }           ///< |a|²
[[nodiscard]] inline double norm(Point a) { return std::sqrt(squaredNorm(a)); }  ///< length
[[nodiscard]] inline double distance(Point a, Point b) { return norm(b - a); }   ///< |b - a|
[[nodiscard]] inline Point midpoint(Point a, Point b) { return 0.5 * (a + b); }  ///< between both
[[nodiscard]] inline Point toLeft(Point a) { return {-a.y, a.x}; }  ///< a turned by 90 degrees

}  // namespace roomgraph
