#include "roomgraph/graph_files/area_labels_png.h"

#include <algorithm>

#include "roomgraph/images/png_bytes.h"

namespace roomgraph {

std::string areaLabelsPng(const AreaGraph& graph, const GridFrame& frame) {
  const auto width = std::ptrdiff_t(frame.width);
  std::vector<std::uint16_t> topFirst(graph.labels.size());
  for (int y = 0; y < frame.height; ++y)
    std::copy_n(graph.labels.begin() + y * width, width,
                topFirst.begin() + (frame.height - 1 - y) * width);
  return pngBytes(topFirst, frame.width, frame.height);
}

}  // namespace roomgraph
