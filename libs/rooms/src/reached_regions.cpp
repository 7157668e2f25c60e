#include "reached_regions.h"

#include <algorithm>

#include "roomgraph/base/UnionFind.h"
#include "roomgraph/rooms/RoomIndex.h"

namespace roomgraph {
namespace {

/** One region at least of each connected part of the graph. */
std::vector<std::uint32_t> seeds(const RegionOutlines& outlines, const RoomGraph& graph) {
  const auto& vertices = graph.graph.vertices();
  UnionFind parts(vertices.size());
  for (const Edge& edge : graph.graph.edges())
    parts.join(std::uint32_t(edge.source.index()), std::uint32_t(edge.target.index()));
  std::vector<std::uint8_t> isFound(vertices.size());
  std::vector<std::uint32_t> found;
  for (const GraphRoom& room : graph.rooms) {
    found.push_back(room.shape.region);
    isFound[parts.find(std::uint32_t(room.vertex.index()))] = 1;
  }
  const auto isMissing = [&](std::uint32_t v) { return !isFound[parts.find(v)]; };
  std::vector<std::uint32_t> missing;
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (isMissing(v)) missing.push_back(v);
  if (missing.empty()) return found;
  const RoomIndex index(outlines.regions);
  for (const std::uint32_t v : missing) {
    const RoomId region = isMissing(v) ? index.roomAt(vertices[v].place) : RoomId::none();
    if (!region) continue;  // on a line between two
    found.push_back(std::uint32_t(region.index()));
    isFound[parts.find(v)] = 1;
  }
  return found;
}

}  // namespace

std::vector<std::uint8_t> reachedRegions(const RegionOutlines& outlines, const RoomGraph& graph,
                                         double clearance) {
  const std::size_t count = outlines.regions.size();
  // A room that is not in the graph is not reached, nor what lies behind it.
  std::vector<std::uint8_t> isOpen(count, 1);
  std::fill_n(isOpen.begin(), outlines.roomCount, std::uint8_t(0));
  for (const GraphRoom& room : graph.rooms) isOpen[room.shape.region] = 1;
  std::fill(isOpen.begin() + outlines.seenCount, isOpen.end(), std::uint8_t(0));

  UnionFind parts(count);
  for (const RegionBorder& border : outlines.borders)
    if (isPassage(border, clearance) && isOpen[border.left] && isOpen[border.right])
      parts.join(border.left, border.right);
  std::vector<std::uint8_t> isReachedPart(count), isReached(count);
  for (const std::uint32_t region : seeds(outlines, graph)) isReachedPart[parts.find(region)] = 1;
  for (std::uint32_t r = 0; r < count; ++r)
    isReached[r] = isOpen[r] && isReachedPart[parts.find(r)];
  return isReached;
}

}  // namespace roomgraph
