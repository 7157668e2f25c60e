#include "roomgraph/graph_files/area_pictures.h"

#include <cstdint>

#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Polyline.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/images/png_bytes.h"

namespace roomgraph {
namespace {

/** Lets nothing near a passage be faster than the passage allows. */
void slowDown(const Passage& passage, const GridFrame& frame, std::vector<std::uint8_t>& greys) {
  const auto grey = std::uint8_t(std::round(2.55 * speedPercent(passage.width / 2)));
  const double reach = kFullSpeedClearance;
  const auto [left, right] = std::minmax(passage.from.x, passage.to.x);
  const auto [bottom, top] = std::minmax(passage.from.y, passage.to.y);
  const Cell low = frame.cellAt({left - reach, bottom - reach});
  const Cell high = frame.cellAt({right + reach, top + reach});
  for (int y = std::max(low.y, 0); y <= std::min(high.y, frame.height - 1); ++y)
    for (int x = std::max(low.x, 0); x <= std::min(high.x, frame.width - 1); ++x) {
      if (distanceToSegment(frame.center({x, y}), passage.from, passage.to) >= reach) continue;
      std::uint8_t& at = greys[frame.index({x, y})];
      at = std::min(at, grey);
    }
}

}  // namespace

std::string areaLabelsPng(const AreaGraph& graph, const GridFrame& frame) {
  return pngBytes(graph.labels, frame.width, frame.height);
}

std::string keepoutMaskPng(const AreaGraph& graph, const GridFrame& frame,
                           const std::vector<RoomId>& keptOut) {
  Grid mask{frame, std::vector<State>(frame.cellCount(), State::free)};
  for (std::size_t i = 0; i < graph.labels.size(); ++i) {
    if (graph.labels[i] == 0 || graph.labels[i] > graph.areas.size()) continue;
    const RoomId room = graph.areas[graph.labels[i] - 1].room;
    if (room && contains(keptOut, room)) mask.cells[i] = State::occupied;
  }
  return mapPng(mask);
}

std::string speedMaskPng(const AreaGraph& graph, const GridFrame& frame) {
  std::vector<std::uint8_t> greys(frame.cellCount(), 255);
  for (const Passage& passage : graph.passages) slowDown(passage, frame, greys);
  return pngBytes(greys, frame.width, frame.height);
}

}  // namespace roomgraph
