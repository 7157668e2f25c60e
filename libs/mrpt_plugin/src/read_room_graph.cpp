#include "roomgraph/mrpt_plugin/read_room_graph.h"

#include "graph_bytes.h"
#include "object_file.h"

namespace roomgraph {

MappedGraph readRoomGraph(const std::string& path) {
  MappedGraph graph;
  readObjectFile(path, {"CRoomGraph", "room graph", "give a .roomgraph file", kGraphBytesVersion},
                 [&](ByteView body) { readGraphBytes(body, path, graph); });
  return graph;
}

}  // namespace roomgraph
