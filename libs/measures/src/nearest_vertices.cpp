#include "roomgraph/measures/nearest_vertices.h"

#include <algorithm>
#include <limits>

namespace roomgraph {

std::optional<double> nearestVertices(const TopologyGraph& base, const TopologyGraph& other) {
  if (base.vertices().empty() || other.vertices().empty()) return std::nullopt;
  double sum = 0;
  for (const Vertex& vertex : base.vertices()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vertex& candidate : other.vertices())
      nearest = std::min(nearest, squaredNorm(candidate.place - vertex.place));
    sum += std::sqrt(nearest);
  }
  return sum / double(base.vertices().size());
}

}  // namespace roomgraph
