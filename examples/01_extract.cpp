// From a map file to its graph: 01_extract MAP writes graph.json and graph.png, and lists the
// rooms.
#include <cstdio>
#include <exception>

#include "roomgraph/base/write_file.h"
#include "roomgraph/drawing/draw.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/map_files/load_grid.h"
#include "roomgraph/pipeline/extract.h"

int main(int count, char** arguments) try {
  if (count != 2) return std::fprintf(stderr, "usage: 01_extract MAP\n"), 2;
  roomgraph::ExtractOptions options;
  options.findRooms.minWidth = 2.0;  // metres

  const roomgraph::GreyMap map = roomgraph::loadGrid(arguments[1], options.loadGrid);
  const roomgraph::Stages stages = roomgraph::extract(map, options);

  for (const roomgraph::GraphRoom& room : stages.result.rooms)
    std::printf("%.1f m2 at (%.1f, %.1f), %zu ways out\n", area(room.shape.polygon), room.center.x,
                room.center.y, room.borderVertices.size());
  roomgraph::writeFileAtomically("graph.json", roomgraph::graphJson(stages));
  roomgraph::writeFileAtomically("graph.png", roomgraph::drawPng(stages));
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
