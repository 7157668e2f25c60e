#include "graph_of_map.h"

#include "roomgraph/base/InputFile.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/graph_files/read_graph_json.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"

namespace roomgraph {

GraphFile graphOfMap(const std::string& file, const ExtractOptions& options) {
  const bool isJson = [&] {
    const CheckedFile opened(file);
    const ByteView head = opened.head();
    return head.size > 0 && head.data[0] == '{';
  }();
  if (isJson) return readGraphJson(file);
  return graphFile(extractGraph(loadGrid(file, options.loadGrid), options));
}

std::string areaName(const GraphFile& file, AreaId area) {
  if (!area) return "nowhere";
  const Area& found = file.areas.areas[area.index()];
  return found.isRoom() ? "R" + std::to_string(found.room.index())
                        : "C" + std::to_string(area.index());
}

}  // namespace roomgraph
