#include "roomgraph/geometry/thinned_line.h"

#include <algorithm>

namespace roomgraph {
namespace {

/** The directions from a point that pass all the points since within the tolerance. */
class Sleeve {
 public:
  Sleeve(Point from, double tolerance) : from_(from), tolerance_(tolerance) {}

  /** Whether a straight line from the start to `p` passes all points so far. */
  bool accepts(Point p) const {
    const Point way = p - from_;
    if (norm(way) < farthest_ - tolerance_) return false;  // the line turns back
    return !isBounded_ || (cross(right_, way) >= 0 && cross(way, left_) >= 0);
  }

  void add(Point p) {
    const Point way = p - from_;
    const double length = norm(way);
    farthest_ = std::max(farthest_, length);
    if (length <= tolerance_) return;
    // The tangents to the disc of the tolerance round p.
    const double sine = tolerance_ / length, cosine = std::sqrt(1 - sine * sine);
    const Point left{cosine * way.x - sine * way.y, sine * way.x + cosine * way.y};
    const Point right{cosine * way.x + sine * way.y, -sine * way.x + cosine * way.y};
    if (!isBounded_ || cross(left, left_) > 0) left_ = left;
    if (!isBounded_ || cross(right_, right) > 0) right_ = right;
    isBounded_ = true;
  }

 private:
  Point from_, left_, right_;
  double tolerance_, farthest_ = 0;
  bool isBounded_ = false;
};

}  // namespace

Polyline thinnedLine(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  Polyline kept{line.front()};
  Sleeve sleeve(line.front(), tolerance);
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (!sleeve.accepts(line[i])) {
      kept.push_back(line[i - 1]);
      sleeve = Sleeve(line[i - 1], tolerance);
    }
    sleeve.add(line[i]);
  }
  kept.push_back(line.back());
  return kept;
}

}  // namespace roomgraph
