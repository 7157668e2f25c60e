#include "roomgraph/topology/Path.h"

#include <algorithm>
#include <limits>

namespace roomgraph {

Path makePath(Polyline points, std::vector<Point> obstacles) {
  Path path;
  path.length = length(points);
  path.minClearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    path.minClearance =
        std::min(path.minClearance, distanceToSegment(obstacles[i], points[i], points[i + 1]));
  path.points = std::move(points);
  path.obstacles = std::move(obstacles);
  return path;
}

Point placeOn(const Path& path, double along) {
  if (along <= 0) return path.points.front();
  return along >= path.length ? path.points.back() : pointAt(path.points, along);
}

double clearanceAt(const Path& path, double along) {
  if (path.obstacles.empty()) return path.minClearance;
  double end = 0;
  std::size_t i = 0;
  for (; i + 1 < path.obstacles.size(); ++i) {
    end += distance(path.points[i], path.points[i + 1]);
    if (along <= end) break;
  }
  return distance(placeOn(path, along), path.obstacles[i]);
}

Path reversed(Path path) {
  std::reverse(path.points.begin(), path.points.end());
  std::reverse(path.obstacles.begin(), path.obstacles.end());
  return path;
}

Path joined(Path a, const Path& b) {
  if (b.points.size() < 2) return a;
  if (a.points.size() < 2) return b;
  a.points.insert(a.points.end(), b.points.begin() + 1, b.points.end());
  a.obstacles.insert(a.obstacles.end(), b.obstacles.begin(), b.obstacles.end());
  a.length += b.length;
  a.minClearance = std::min(a.minClearance, b.minClearance);
  return a;
}

Path piece(const Path& path, double from, double to) {
  Polyline points{placeOn(path, from)};
  std::vector<Point> obstacles;
  double along = 0;
  for (std::size_t i = 0; i + 1 < path.points.size() && along < to; ++i) {
    const double end = along + distance(path.points[i], path.points[i + 1]);
    if (end > from) {
      points.push_back(end < to ? path.points[i + 1] : placeOn(path, to));
      if (!path.obstacles.empty()) obstacles.push_back(path.obstacles[i]);
    }
    along = end;
  }
  points.back() = placeOn(path, to);
  Path part = makePath(std::move(points), std::move(obstacles));
  if (part.obstacles.empty()) part.minClearance = clearanceAt(path, to);
  return part;
}

}  // namespace roomgraph
