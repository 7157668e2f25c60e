#include "roomgraph/areas/area_graph.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "label_areas.h"
#include "reached_regions.h"
#include "roomgraph/rooms/trace_rooms.h"

namespace roomgraph {
namespace {

/** The area of each region: the rooms of the graph in its order, then the corridors. */
std::vector<AreaId> numberAreas(const Regions& regions, const RoomGraph& graph,
                                const std::vector<std::uint8_t>& isReached) {
  std::vector<AreaId> areaOf(regions.count);
  std::size_t count = 0;
  for (const GraphRoom& room : graph.rooms) areaOf[room.shape.region] = AreaId(count++);
  for (std::uint32_t r = regions.roomCount; r < regions.count; ++r)
    if (isReached[r]) areaOf[r] = AreaId(count++);
  return areaOf;
}

std::vector<Area> makeAreas(Rooms traced, const RoomGraph& graph,
                            const std::vector<AreaId>& areaOf) {
  std::vector<Area> areas;
  for (std::uint32_t r = 0; r < traced.size(); ++r) {
    if (!areaOf[r]) continue;
    areas.resize(std::max(areas.size(), areaOf[r].index() + 1));
    Area& area = areas[areaOf[r].index()];
    area.polygon = std::move(traced[r].polygon);
    area.widestPlace = traced[r].widestPlace;
    area.inscribedRadius = traced[r].inscribedRadius;
  }
  for (std::size_t i = 0; i < graph.rooms.size(); ++i) areas[i].room = RoomId(i);
  return areas;
}

std::vector<Passage> findPassages(const ClearedSpace& space, const std::vector<AreaId>& areaOf,
                                  double clearance) {
  std::vector<Passage> passages;
  const auto& sites = space.voronoi.sites;
  for (const VoronoiEdge& edge : space.voronoi.edges) {
    if (!isPassage(edge, space.regions, clearance)) continue;
    Passage passage{areaOf[space.regions.of(edge.source)], areaOf[space.regions.of(edge.target)],
                    sites[edge.left], sites[edge.right], 0};
    if (!passage.a || !passage.b) continue;
    // Seen from the area with the smaller number, `from` is on the left.
    if (passage.b < passage.a) {
      std::swap(passage.a, passage.b);
      std::swap(passage.from, passage.to);
    }
    passage.width = distance(passage.from, passage.to);
    passages.push_back(passage);
  }
  const auto key = [](const Passage& p) {
    return std::make_tuple(p.a, p.b, p.from.x, p.from.y, p.to.x, p.to.y);
  };
  std::sort(passages.begin(), passages.end(),
            [&](const Passage& p, const Passage& q) { return key(p) < key(q); });
  return passages;
}

}  // namespace

AreaGraph areaGraph(const ClearedSpace& space, const RoomGraph& graph, double clearance,
                    Notes& notes) {
  Rooms traced = traceRegions(space.voronoi, space.regions);
  const std::vector<AreaId> areaOf =
      numberAreas(space.regions, graph, reachedRegions(space, traced, graph, clearance));
  AreaGraph result;
  result.areas = makeAreas(std::move(traced), graph, areaOf);
  result.passages = findPassages(space, areaOf, clearance);
  for (std::size_t p = 0; p < result.passages.size(); ++p)
    for (const AreaId area : {result.passages[p].a, result.passages[p].b})
      result.areas[area.index()].passages.push_back(PassageId(p));
  result.labels = labelAreas(space, areaOf);
  if (result.areas.size() >= 65535)
    notes.push_back({"too_many_areas", "areas beyond the first 65534 have no label", std::nullopt});
  return result;
}

}  // namespace roomgraph
