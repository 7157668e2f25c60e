#include "read_areas.h"

namespace roomgraph {
namespace {

Area readArea(const JsonNode& node, std::size_t roomCount, std::size_t passageCount) {
  Area area;
  area.room = readIdOrNone<RoomId>(node["room"], roomCount);
  if (node["kind"].text() != (area.isRoom() ? "room" : "corridor"))
    throw Broken{node.place + ".kind", "does not fit to its room"};
  area.polygon = readPolygon(node);
  area.widestPlace = readPoint(node["widest_place"]);
  area.inscribedRadius = node["inscribed_radius"].number();
  for (const JsonNode& passage : node["passages"].list())
    area.passages.push_back(readId<PassageId>(passage, passageCount));
  return area;
}

Passage readPassage(const JsonNode& node, std::size_t areaCount) {
  const auto areas = node["areas"].list();
  if (areas.size() != 2) throw Broken{node.place + ".areas", "is not a pair [area, area]"};
  const auto ends = readPoints(node["ends"]);
  if (ends.size() != 2) throw Broken{node.place + ".ends", "is not a pair [point, point]"};
  return {readId<AreaId>(areas[0], areaCount), readId<AreaId>(areas[1], areaCount), ends[0],
          ends[1], node["width"].number()};
}

}  // namespace

AreaGraph readAreas(const JsonNode& top, std::size_t roomCount) {
  AreaGraph graph;
  if (!top.contains("areas") && !top.contains("passages")) return graph;
  const auto areaNodes = top["areas"].list(), passageNodes = top["passages"].list();
  for (const JsonNode& node : areaNodes) {
    node.checkId(graph.areas.size());
    graph.areas.push_back(readArea(node, roomCount, passageNodes.size()));
  }
  for (const JsonNode& node : passageNodes) {
    node.checkId(graph.passages.size());
    graph.passages.push_back(readPassage(node, areaNodes.size()));
  }
  return graph;
}

}  // namespace roomgraph
