#include "roomgraph/mrpt_plugin/room_graph_file.h"

#include "object_bytes.h"
#include "roomgraph/base/write_file.h"

namespace roomgraph {

std::string roomGraphBytes(const CRoomGraph& graph) {
  checkMapSize(graph);  // here, for MRPT's streams would wrap the message into a backtrace
  return gzippedObject(graph);
}

void saveRoomGraph(const std::string& path, const CRoomGraph& graph) {
  writeFileAtomically(path, roomGraphBytes(graph));
}

CRoomGraph loadRoomGraph(const std::string& path) {
  CRoomGraph graph;
  readObjectFile(path, kRoomGraphObject, [&](ByteView body) { readGraphBytes(body, path, graph); });
  return graph;
}

}  // namespace roomgraph
