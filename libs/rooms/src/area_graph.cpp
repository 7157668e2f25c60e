#include "roomgraph/rooms/area_graph.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "label_areas.h"
#include "passage_evidence.h"

namespace roomgraph {
namespace {

/** The area of each region: the rooms of the graph in its order, then the corridors. */
std::vector<AreaId> numberAreas(const RegionOutlines& outlines, const RoomGraph& graph,
                                const std::vector<std::uint8_t>& isReached) {
  std::vector<AreaId> areaOf(outlines.regions.size());
  std::size_t count = 0;
  for (const GraphRoom& room : graph.rooms) areaOf[room.shape.region] = AreaId(count++);
  for (std::size_t r = outlines.roomCount; r < outlines.seenCount; ++r)
    if (isReached[r]) areaOf[r] = AreaId(count++);
  return areaOf;
}

std::vector<Area> makeAreas(const Rooms& shapes, const RoomGraph& graph,
                            const std::vector<AreaId>& areaOf) {
  std::vector<Area> areas;
  for (std::size_t r = 0; r < shapes.size(); ++r) {
    if (!areaOf[r]) continue;
    areas.resize(std::max(areas.size(), areaOf[r].index() + 1));
    Area& area = areas[areaOf[r].index()];
    area.polygon = shapes[r].polygon;
    area.widestPlace = shapes[r].widestPlace;
    area.inscribedRadius = shapes[r].inscribedRadius;
    area.seen = shapes[r].seen;
  }
  for (std::size_t i = 0; i < graph.rooms.size(); ++i) areas[i].room = RoomId(i);
  return areas;
}

/** A door to half-seen space has walls at both ends: else it is but where a beam ends. */
bool isDoorToUnseen(const RegionOutlines& outlines, const RegionBorder& border) {
  return std::max(border.left, border.right) >= outlines.seenCount && border.wallEnds == 2;
}

std::vector<Passage> findPassages(const Grid& grid, const RegionOutlines& outlines,
                                  const std::vector<AreaId>& areaOf, double clearance,
                                  const SplitAtDoorsOptions& doors) {
  std::vector<Passage> passages;
  for (const RegionBorder& border : outlines.borders) {
    if (!isPassage(border, clearance)) continue;
    // Who leaves the area on the left has the way's end on the left.
    Passage passage{areaOf[border.left], areaOf[border.right], border.to, border.from, 0};
    if (!passage.a && !passage.b) continue;
    if ((!passage.a || !passage.b) && !isDoorToUnseen(outlines, border)) continue;
    if (passage.b < passage.a) {
      std::swap(passage.a, passage.b);
      std::swap(passage.from, passage.to);
    }
    passage.width = distance(passage.from, passage.to);
    const double radius = std::min(outlines.regions[border.left].inscribedRadius,
                                   outlines.regions[border.right].inscribedRadius);
    passage.evidence = passageEvidence(grid, border, radius, doors);
    if (!passage.b) passage.evidence.confidence /= 2;  // of two sides one is known
    passages.push_back(passage);
  }
  std::sort(passages.begin(), passages.end(), [](const Passage& p, const Passage& q) {
    return std::tie(p.a, p.b, p.from, p.to) < std::tie(q.a, q.b, q.from, q.to);
  });
  return passages;
}

}  // namespace

AreaGraph areaGraph(const Grid& grid, const RegionOutlines& outlines, const RoomGraph& graph,
                    double clearance, const SplitAtDoorsOptions& doors, Notes& notes) {
  const std::vector<AreaId> areaOf =
      numberAreas(outlines, graph, reachedRegions(outlines, graph, clearance));
  AreaGraph result;
  result.areas = makeAreas(outlines.regions, graph, areaOf);
  result.passages = findPassages(grid, outlines, areaOf, clearance, doors);
  for (std::size_t p = 0; p < result.passages.size(); ++p)
    for (const AreaId area : {result.passages[p].a, result.passages[p].b})
      if (area) result.areas[area.index()].passages.push_back(PassageId(p));
  result.labels = labelCells(grid, outlines.borders, areaOf);
  if (result.areas.size() > kMaxLabelledAreas)
    notes.push_back({"too_many_areas",
                     "the map has more areas than a label picture can tell apart: the last of them "
                     "have no label",
                     std::nullopt});
  return result;
}

}  // namespace roomgraph
