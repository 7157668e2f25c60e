#include "roomgraph/rooms/border_vertices.h"

#include <algorithm>

#include "roomgraph/geometry/intersect.h"
#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {
namespace {

/** Distances from the source at which the path meets a polygon, ascending. */
std::vector<double> meetings(const Path& path, const RoomIndex& index) {
  std::vector<double> distances;
  double along = 0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Point p = path.points[i], q = path.points[i + 1];
    const double step = distance(p, q);
    for (const auto& [a, b] : index.openingsNear(p, q))
      for (const double fraction : intersect(p, q, a, b))
        distances.push_back(along + fraction * step);
    along += step;
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

std::vector<Stretch> stretchesOf(const Path& path, const RoomIndex& index, double epsilon) {
  std::vector<double> bounds{0};
  for (const double at : meetings(path, index))
    if (at > bounds.back() + epsilon && at < path.length - epsilon) bounds.push_back(at);
  bounds.push_back(path.length);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const double middle = (bounds[i] + bounds[i + 1]) / 2;
    const RoomId room = index.roomAt(pointAt(path.points, middle));
    if (!stretches.empty() && stretches.back().room == room)
      stretches.back().to = bounds[i + 1];
    else
      stretches.push_back({bounds[i], bounds[i + 1], room});
  }
  return stretches;
}

}  // namespace

PathStretches borderVertices(const TopologyGraph& graph, const Rooms& rooms, double clearance,
                             double epsilon) {
  const RoomIndex index(rooms, clearance);
  PathStretches stretches;
  stretches.reserve(graph.edges().size());
  for (const Edge& edge : graph.edges())
    stretches.push_back(stretchesOf(edge.path, index, epsilon));
  return stretches;
}

}  // namespace roomgraph
