#include "roomgraph/geometry/Polyline.h"

namespace roomgraph {

double length(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

Point pointAt(const Polyline& line, double along) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (along < step) return line[i - 1] + std::max(0.0, along / step) * (line[i] - line[i - 1]);
    along -= step;
  }
  return line.back();
}

double distanceToSegment(Point p, Point a, Point b) {
  return distance(p, nearestOnSegment(p, a, b));
}

}  // namespace roomgraph
