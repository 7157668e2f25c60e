#include "path_frechet.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fitted_measures.h"
#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

/** `steps` + 1 places, evenly along the line. */
std::vector<Point> evenly(const Polyline& line, double length, int steps) {
  std::vector<Point> places{line.front()};
  double along = 0;  // up to the start of the segment
  std::size_t i = 0;
  for (int k = 1; k < steps; ++k) {
    const double want = length * k / steps;
    double segment = distance(line[i], line[i + 1]);
    while (along + segment < want && i + 2 < line.size()) {
      along += segment;
      ++i;
      segment = distance(line[i], line[i + 1]);
    }
    const double share = segment > 0 ? std::min(1.0, (want - along) / segment) : 0;
    places.push_back(line[i] + share * (line[i + 1] - line[i]));
  }
  places.push_back(line.back());
  return places;
}

double frechet(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double left = 0, below = 0;  // of the cell before, in this row and in the last one
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double old = row[j];
      double reached = 0;
      if (i > 0 && j > 0)
        reached = std::min({left, old, below});
      else if (i + j > 0)
        reached = i > 0 ? old : left;
      row[j] = std::max(reached, squaredNorm(a[i] - b[j]));
      below = old, left = row[j];
    }
  }
  return std::sqrt(row.back());
}

}  // namespace

std::optional<double> pathFrechet(const Polyline& a, const Polyline& b) {
  const double ofA = length(a), ofB = length(b);
  if (ofA <= 0 || ofB <= 0) return std::nullopt;
  // Even a short path has a shape, and a long one costs no more than a bounded time.
  const int steps = std::clamp(int(std::max(ofA, ofB) / fitted::kPathStep), 8, 64);
  const std::vector<Point> onA = evenly(a, ofA, steps);
  std::vector<Point> onB = evenly(b, ofB, steps);
  const bool isLoop = distance(a.front(), a.back()) < fitted::kLoop * ofA ||
                      distance(b.front(), b.back()) < fitted::kLoop * ofB;
  MotionFit fit;
  for (std::size_t i = 0; i < onA.size(); ++i)
    if (isLoop || i == 0 || i + 1 == onA.size()) fit.add(onB[i], onA[i]);
  const Motion2D move(fit.motion());
  for (Point& p : onB) p = move(p);
  return frechet(onA, onB);
}

}  // namespace roomgraph
