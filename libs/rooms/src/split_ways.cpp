#include "split_ways.h"

#include <algorithm>

#include "place_on_paths.h"

namespace roomgraph {

VertexId splitAt(std::vector<Vertex>& vertices, std::vector<Edge>& edges, PlaceOnPath place,
                 VertexKind kind) {
  Edge& whole = edges[place.edge.index()];
  const double rest = whole.path.length - place.along;
  if (std::min(place.along, rest) < kSamePlace)
    return place.along <= rest ? whole.source : whole.target;
  const VertexId middle(vertices.size());
  vertices.push_back(
      {placeOn(whole.path, place.along), clearanceAt(whole.path, place.along), kind, whole.room});
  Edge second{middle, whole.target, piece(whole.path, place.along, whole.path.length), whole.room};
  whole.path = piece(whole.path, 0, place.along);
  whole.target = middle;
  edges.push_back(std::move(second));
  return middle;
}

}  // namespace roomgraph
